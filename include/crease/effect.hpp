// SPDX-License-Identifier: MIT
#pragma once

#include <crease/program.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <utility>

namespace crease {

/// The parameters with each part's recommended settings, and no view yet.
constexpr parameters default_parameters(std::span<const choice> choices) {
    parameters p;
    for (const choice& c : choices)
        for (const setting& s : c.what->settings)
            p.*s.field = s.fallback;
    return p;
}

/// What the passes of a plan require of a device.
constexpr device_features required_features(const plan& p) {
    device_features required;
    if (p.chosen(role::stage).what->stage_of == stage_kind::compute &&
        p.chosen(role::dialect).what->dialect_of == dialect_kind::vulkan)
        for (const planned_pass& pass : p.passes)
            required.extended_storage_formats |= p.resources[pass.output].texels == format::r8_unorm;
    return required;
}

namespace joining {

template <std::size_t Size>
struct block {
    char characters[Size];
};

// A block per place, as a type may be a base only once.
template <std::size_t, class Block>
struct placed : Block {};

template <class... Blocks>
struct joined : Blocks... {};

template <std::size_t Size>
constexpr block<Size> copy(const char* from) {
    block<Size> b{};
    for (std::size_t i = 0; i < Size; ++i)
        b.characters[i] = from[i];
    return b;
}

/// The list without its unused places.
template <std::size_t Count, class Item, std::size_t Capacity>
constexpr std::array<Item, Count> shrink(const fixed_list<Item, Capacity>& list) {
    std::array<Item, Count> all{};
    for (std::size_t i = 0; i < Count; ++i)
        all[i] = list[i];
    return all;
}

// Each file's characters are copied once, however many programs hold them.
template <const glsl_file* File>
inline constexpr auto block_of = copy<File->text.size()>(File->text.data());

}

/// An ambient-occlusion effect, composed at compile time.
///
/// `Sampler`, `DepthSource` and `Estimator` make the main pass; `Rest` are filters, in the order in which
/// they run, and the view parts, the stage and the dialect, where they differ from the defaults (perspective,
/// device_depth, given_normals, compute, vulkan_glsl). Parts that do not fit fail to compile, with one
/// sentence.
template <class Sampler, class DepthSource, class Estimator, class... Rest>
class effect {
    static constexpr bool legal = rules::assert_all<Sampler, DepthSource, Estimator, Rest...>();

    static constexpr plan make() {
        if constexpr (legal) {
            const choice chosen[] = {choice_of<Sampler>(), choice_of<DepthSource>(), choice_of<Estimator>(),
                                     choice_of<Rest>()...};
            return make_plan(chosen);
        } else {
            return plan{}; // no second error after the assertion's
        }
    }

    static constexpr plan planned = make();

    static constexpr std::size_t pass_count = planned.passes.size();

    template <std::size_t Pass>
    static constexpr interface_text interface_draft = program_writer(planned, Pass).interface();

    template <std::size_t Pass>
    static constexpr auto
        interface_block = joining::copy<interface_draft<Pass>.count>(interface_draft<Pass>.characters);

    template <std::size_t Pass>
    static constexpr glsl_file interface_piece{
        "interface", std::string_view(interface_block<Pass>.characters, interface_draft<Pass>.count)};

    template <std::size_t Pass>
    static constexpr file_list files = program_writer(planned, Pass).files();

    template <std::size_t Pass, std::size_t... I>
    static constexpr std::array<piece, 1 + sizeof...(I)> list_pieces(std::index_sequence<I...>) {
        return {interface_piece<Pass>, *files<Pass>[I]...};
    }

    template <std::size_t Pass>
    static constexpr auto pieces_of = list_pieces<Pass>(std::make_index_sequence<files<Pass>.size()>{});

    template <std::size_t Pass>
    static constexpr binding_list binding_draft = program_writer(planned, Pass).bindings();

    template <std::size_t Pass>
    static constexpr auto bindings_of = joining::shrink<binding_draft<Pass>.size()>(binding_draft<Pass>);

    template <std::size_t Pass>
    static constexpr constant_list constant_draft = program_writer(planned, Pass).constants();

    template <std::size_t Pass>
    static constexpr auto constants_of = joining::shrink<constant_draft<Pass>.size()>(constant_draft<Pass>);

    template <std::size_t Pass>
    static constexpr pass describe() {
        pass p = program_writer(planned, Pass).describe();
        p.pieces = pieces_of<Pass>;
        p.bindings = bindings_of<Pass>;
        p.constants = constants_of<Pass>;
        p.vertex_pieces = program_writer(planned, Pass).vertex_pieces();
        return p;
    }

    template <std::size_t Pass, std::size_t... I>
    static constexpr auto join(std::index_sequence<I...>) {
        using namespace joining;
        using whole = joined<placed<0, block<interface_draft<Pass>.count>>,
                             placed<1 + I, block<files<Pass>[I] -> text.size()>>...,
                             placed<1 + sizeof...(I), block<1>>>;
        return std::bit_cast<std::array<char, sizeof(whole)>>(
            whole{{interface_block<Pass>}, {block_of<files<Pass>[I]>}..., {block<1>{{'\0'}}}});
    }

    template <std::size_t Pass>
    static constexpr auto text = join<Pass>(std::make_index_sequence<files<Pass>.size()>{});

    template <std::size_t... I>
    static constexpr std::array<pass, pass_count> list_passes(std::index_sequence<I...>) {
        return {describe<I>()...};
    }

public:
    /// The passes in the order of execution.
    static constexpr std::array<pass, pass_count> passes =
        list_passes(std::make_index_sequence<pass_count>{});

    /// The resources that the passes use; 0 is the block of parameters, the last the output.
    static constexpr auto resources = joining::shrink<planned.resources.size()>(planned.resources);

    /// The device features that all passes together require.
    static constexpr device_features features = required_features(planned);

    /// The settings as the parts recommend them; the host adds the view (`set_projection`) and the radius.
    static constexpr parameters defaults =
        default_parameters({planned.choices.data(), planned.choices.size()});

    /// The whole text of a pass, NUL-terminated, with static storage; made only where it is named.
    template <std::size_t Pass>
    static constexpr std::string_view source{text<Pass>.data(), text<Pass>.size() - 1};

    /// The effect as data, for a renderer.
    static constexpr effect_view view() { return {passes, resources, features, defaults}; }
    constexpr operator effect_view() const { return view(); }
};

}
