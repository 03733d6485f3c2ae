// SPDX-License-Identifier: MIT
#pragma once

#include <crease/outline.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

namespace crease {

/// An ambient-occlusion effect, composed at compile time.
///
/// `Sampler`, `DepthSource` and `Estimator` make the main pass; `Rest` are filters, in the order in which
/// they run, and the view parts, the stage and the dialect, where they differ from the defaults (perspective,
/// device_depth, given_normals, hashed_noise, visibility_only, compute, vulkan_glsl). Parts that do not fit
/// fail to compile, with one sentence.
template <class Sampler, class DepthSource, class Estimator, class... Rest>
class effect {
    static constexpr bool legal = rules::assert_all<Sampler, DepthSource, Estimator, Rest...>();

    using shared = outline<typename outlining::legal_parts<legal, Sampler, DepthSource, Estimator, Rest...>::type>;

    static constexpr std::size_t capture_count = shared::capture_count, pass_count = shared::pass_count;

    static constexpr choice chosen[] = {choice_of<Sampler>(), choice_of<DepthSource>(), choice_of<Estimator>(),
                                        choice_of<Rest>()...};

    /// What stands in a gap of a program's interface.
    template <std::size_t Program, std::size_t Gap>
    static constexpr int
        number_in = open_number::value_of(shared::template gaps<Program>[Gap].number, chosen);

    template <std::size_t Program, std::size_t... Gap>
    using interface_blocks = joining::joined<
        joining::placed<Gap, joining::pair<typename shared::template run_block<Program, Gap>,
                                           joining::block<digits_of(number_in<Program, Gap>)>>>...,
        joining::placed<sizeof...(Gap), typename shared::template run_block<Program, sizeof...(Gap)>>>;

    // A variable: a compiler copies the results and arguments of calls.
    template <std::size_t Program, std::size_t... Gap>
    static constexpr interface_blocks<Program, Gap...> joined_interface{
        {{shared::template run<Program, Gap>(), joining::digits<number_in<Program, Gap>>}}...,
        {shared::template run<Program, sizeof...(Gap)>()}};

    template <std::size_t Program, std::size_t... Gap>
    static constexpr const auto& join_interface(std::index_sequence<Gap...>) {
        return joined_interface<Program, Gap...>;
    }

    template <std::size_t Program>
    static constexpr const auto& interface() {
        return join_interface<Program>(std::make_index_sequence<shared::template gaps<Program>.size()>{});
    }

    template <std::size_t Program>
    static constexpr joining::characters<sizeof(interface<Program>())> interface_characters =
        __builtin_bit_cast(joining::characters<sizeof(interface<Program>())>, interface<Program>());

    template <std::size_t Program>
    static constexpr glsl_file interface_piece{
        "interface", std::string_view(interface_characters<Program>.items, sizeof(interface<Program>()))};

    template <std::size_t Program, std::size_t... I>
    static constexpr std::array<piece, 1 + sizeof...(I)> list_pieces(std::index_sequence<I...>) {
        return {interface_piece<Program>, *shared::template draft<Program>.files[I]...};
    }

    template <std::size_t Program>
    static constexpr auto
        pieces_of = list_pieces<Program>(std::make_index_sequence<shared::template file_count<Program>>{});

    template <std::size_t Program>
    static constexpr auto list_constants() {
        const constant_list& open = shared::template draft<Program>.constants;
        auto all = shrink<shared::template draft<Program>.constants.size()>(open);
        for (constant& c : all)
            c.value = open_number::value_of(c.value, chosen);
        return all;
    }

    template <std::size_t Program>
    static constexpr auto constants_of = list_constants<Program>();

    /// A pass or a capture with its lists.
    template <std::size_t Program>
    static constexpr auto described() {
        auto whole = describe(shared::planned, shared::template planned_program<Program>());
        whole.pieces = pieces_of<Program>;
        whole.bindings = shared::template bindings<Program>;
        whole.constants = constants_of<Program>;
        return whole;
    }

    template <std::size_t Program>
    static constexpr joining::text_of<
        joining::pair<std::remove_cvref_t<decltype(interface<Program>())>,
                      std::remove_cvref_t<decltype(shared::template files<Program>())>>>
        text{{interface<Program>(), shared::template files<Program>()}};

    template <std::size_t... I>
    static constexpr std::array<pass, pass_count> list_passes(std::index_sequence<I...>) {
        return {described<capture_count + I>()...};
    }

    template <std::size_t... I>
    static constexpr std::array<capture, sizeof...(I)> list_captures(std::index_sequence<I...>) {
        return {described<I>()...};
    }

public:
    /// What the host's geometry pass fills before the passes run; none for most effects.
    static constexpr auto captures = list_captures(std::make_index_sequence<capture_count>{});

    /// The passes in the order of execution.
    static constexpr std::array<pass, pass_count> passes =
        list_passes(std::make_index_sequence<pass_count>{});

    /// The resources that the passes use; 0 is the block of parameters, the outputs are the last.
    static constexpr const auto& resources = shared::resources;

    /// The device features that all passes together require.
    static constexpr const device_features& features = shared::features;

    /// The settings as the parts recommend them; the host adds the view (`set_projection`) and the radius.
    static constexpr const parameters& defaults = shared::defaults;

    /// The whole text of a pass, NUL-terminated, with static storage; made only where it is named. Its
    /// characters are read at run time, as they are kept in words; constant expressions read `pieces`.
    template <std::size_t Pass>
    static constexpr std::string_view source = joining::view_of(text<capture_count + Pass>);

    /// The whole text of a capture, likewise.
    template <std::size_t Capture>
    static constexpr std::string_view capture_source = joining::view_of(text<Capture>);

    /// The effect as data, for a renderer.
    static constexpr effect_view view() { return {captures, passes, resources, features, defaults}; }
    constexpr operator effect_view() const { return view(); }
};

}
