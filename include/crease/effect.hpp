// SPDX-License-Identifier: MIT
#pragma once

#include <crease/outline.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace crease {

/// An effect's own: what depends on the numbers that its outline leaves open.
namespace composing {

/// The number of a gap of a program's interface.
template <class Effect, std::size_t Program, std::size_t Gap>
using number_in = joining::number<open_number::value_of(
    outlining::gaps<typename Effect::outline, Program>[Gap].number, Effect::choices)>;

template <class Effect, std::size_t Program, class Gaps>
struct filled;
template <class Effect, std::size_t Program, std::size_t... Gap>
struct filled<Effect, Program, std::index_sequence<Gap...>> {
    using runs = outlining::runs<typename Effect::outline, Program>;
    using blocks = joining::sequence<joining::pair<typename runs::template before<Gap>,
                                                   typename number_in<Effect, Program, Gap>::characters>...,
                                     typename runs::last>;
    static constexpr blocks value{
        {{joining::block_in<Gap>(runs::value), number_in<Effect, Program, Gap>::text}}...,
        {joining::block_in<sizeof...(Gap)>(runs::value)}};
};

/// A program's interface, with its numbers.
template <class Effect, std::size_t Program>
using interface = filled<Effect, Program,
                         std::make_index_sequence<outlining::gaps<typename Effect::outline, Program>.size()>>;

template <class Effect, std::size_t Program>
inline constexpr joining::characters<sizeof(interface<Effect, Program>::value)>
    interface_characters = __builtin_bit_cast(joining::characters<sizeof(interface<Effect, Program>::value)>,
                                              interface<Effect, Program>::value);

template <class Effect, std::size_t Program>
inline constexpr glsl_file interface_piece{
    "interface",
    std::string_view(interface_characters<Effect, Program>.items, sizeof(interface<Effect, Program>::value))};

template <class Effect, std::size_t Program, std::size_t... I>
constexpr std::array<piece, 1 + sizeof...(I)> list_pieces(std::index_sequence<I...>) {
    return {interface_piece<Effect, Program>,
            *outlining::draft<typename Effect::outline, Program>.files[I]...};
}

template <class Effect, std::size_t Program>
inline constexpr auto pieces = list_pieces<Effect, Program>(
    std::make_index_sequence<outlining::draft<typename Effect::outline, Program>.files.size()>{});

template <class Effect, std::size_t Program>
constexpr auto list_constants() {
    constexpr auto& draft = outlining::draft<typename Effect::outline, Program>;
    auto all = shrink<draft.constants.size()>(draft.constants);
    for (constant& c : all)
        c.value = open_number::value_of(c.value, Effect::choices);
    return all;
}

template <class Effect, std::size_t Program>
inline constexpr auto constants = list_constants<Effect, Program>();

/// A pass or a capture with its lists.
template <class Effect, std::size_t Program>
constexpr auto described() {
    using parts = typename Effect::outline;
    auto whole = describe(outlining::planned<parts>, outlining::planned_program<parts, Program>());
    whole.pieces = pieces<Effect, Program>;
    whole.bindings = outlining::bindings<parts, Program>;
    whole.constants = constants<Effect, Program>;
    return whole;
}

template <class Effect, std::size_t... I>
constexpr std::array<pass, sizeof...(I)> list_passes(std::index_sequence<I...>) {
    return {described<Effect, outlining::capture_count<typename Effect::outline> + I>()...};
}

template <class Effect, std::size_t... I>
constexpr std::array<capture, sizeof...(I)> list_captures(std::index_sequence<I...>) {
    return {described<Effect, I>()...};
}

template <class Effect, std::size_t Program, class Groups>
struct whole;
template <class Effect, std::size_t Program, std::size_t... Group>
struct whole<Effect, Program, std::index_sequence<Group...>> {
    template <std::size_t At>
    using group = outlining::file_group<typename Effect::outline, Program, At>;
    using interface = composing::interface<Effect, Program>;
    static constexpr joining::text_of<
        joining::sequence<typename interface::blocks, typename group<Group>::blocks..., joining::block<1>>>
        text{{{interface::value}, {group<Group>::text}..., {joining::block<1>{{'\0'}}}}};
};

/// The whole text of a program, NUL-terminated.
template <class Effect, std::size_t Program>
inline constexpr std::string_view text =
    joining::view_of(whole<Effect, Program, outlining::file_groups<typename Effect::outline, Program>>::text);

}

/// An ambient-occlusion effect, composed at compile time.
///
/// `Sampler`, `DepthSource` and `Estimator` make the main pass; `Rest` are filters, in the order in which
/// they run, and the view parts, the stage and the dialect, where they differ from the defaults (perspective,
/// device_depth, given_normals, hashed_noise, visibility_only, compute, vulkan_glsl). Parts that do not fit
/// fail to compile, with one sentence.
template <class Sampler, class DepthSource, class Estimator, class... Rest>
struct effect {
    /// What it has in common with effects that differ only in numbers.
    using outline = rules::legal_outline<Sampler, DepthSource, Estimator, Rest...>;

    /// The parts with their numbers: a `recipe` of them is the same effect at run time.
    static constexpr choice choices[] = {choice_of<Sampler>(), choice_of<DepthSource>(),
                                         choice_of<Estimator>(), choice_of<Rest>()...};

    /// What the host's geometry pass fills before the passes run; none for most effects.
    static constexpr std::array<capture, outlining::capture_count<outline>> captures =
        composing::list_captures<effect>(std::make_index_sequence<outlining::capture_count<outline>>{});

    /// The passes in the order of execution.
    static constexpr std::array<pass, outlining::pass_count<outline>> passes =
        composing::list_passes<effect>(std::make_index_sequence<outlining::pass_count<outline>>{});

    /// The resources that the passes use; 0 is the block of parameters, the outputs are the last.
    static constexpr const std::array<resource, outlining::planned<outline>.resources.size()>& resources =
        outlining::resources<outline>;

    /// The device features that all passes together require.
    static constexpr const device_features& features = outlining::features<outline>;

    /// The settings as the parts recommend them; the host adds the view (`set_projection`) and the radius.
    static constexpr const parameters& defaults = outlining::defaults<outline>;

    /// The whole text of a pass, NUL-terminated, with static storage; made only where it is named. Its
    /// characters are read at run time, as they are kept in words; constant expressions read `pieces`.
    template <std::size_t Pass>
    static constexpr std::string_view source =
        composing::text<effect, outlining::capture_count<outline> + Pass>;

    /// The whole text of a capture, likewise.
    template <std::size_t Capture>
    static constexpr std::string_view capture_source = composing::text<effect, Capture>;

    /// The effect as data, for a renderer.
    static constexpr effect_view view() { return {captures, passes, resources, features, defaults}; }
    constexpr operator effect_view() const { return view(); }
};

}
