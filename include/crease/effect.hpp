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

/// What the captures and passes of a plan require of a device.
constexpr device_features required_features(const plan& p) {
    device_features required;
    const bool vulkan = p.chosen(role::dialect).what->dialect_of == dialect_kind::vulkan;
    for (const planned_capture& c : p.captures) {
        required.fragment_stores_and_atomics |= vulkan && c.what->how == access::modify;
        if (c.what->how == access::attachment)
            required.depth_samples |= p.resources[c.output].samples;
    }
    for (const planned_pass& pass : p.passes)
        if (vulkan && writing::stage_of(p, pass) == stage_kind::compute)
            for (unsigned output : pass.outputs)
                required.extended_storage_formats |= facts_of(p.resources[output].texels).extended;
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
/// device_depth, given_normals, hashed_noise, visibility_only, compute, vulkan_glsl). Parts that do not fit
/// fail to compile, with one sentence.
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

    template <const auto* Planned>
    static constexpr program draft = write_program(planned, *Planned);

    template <const auto* Planned>
    static constexpr auto
        interface_block = joining::copy<draft<Planned>.interface.count>(draft<Planned>.interface.characters);

    template <const auto* Planned>
    static constexpr glsl_file interface_piece{
        "interface", std::string_view(interface_block<Planned>.characters, draft<Planned>.interface.count)};

    template <const auto* Planned, std::size_t... I>
    static constexpr std::array<piece, 1 + sizeof...(I)> list_pieces(std::index_sequence<I...>) {
        return {interface_piece<Planned>, *draft<Planned>.files[I]...};
    }

    template <const auto* Planned>
    static constexpr auto
        pieces_of = list_pieces<Planned>(std::make_index_sequence<draft<Planned>.files.size()>{});

    template <const auto* Planned>
    static constexpr auto
        bindings_of = joining::shrink<draft<Planned>.bindings.size()>(draft<Planned>.bindings);

    template <const auto* Planned>
    static constexpr auto
        constants_of = joining::shrink<draft<Planned>.constants.size()>(draft<Planned>.constants);

    /// A pass or a capture with its lists.
    template <const auto* Planned>
    static constexpr auto described() {
        auto whole = describe(planned, *Planned);
        whole.pieces = pieces_of<Planned>;
        whole.bindings = bindings_of<Planned>;
        whole.constants = constants_of<Planned>;
        return whole;
    }

    template <const auto* Planned, std::size_t... I>
    static constexpr auto join(std::index_sequence<I...>) {
        using namespace joining;
        using whole = joined<placed<0, block<draft<Planned>.interface.count>>,
                             placed<1 + I, block<draft<Planned>.files[I]->text.size()>>...,
                             placed<1 + sizeof...(I), block<1>>>;
        return std::bit_cast<std::array<char, sizeof(whole)>>(
            whole{{interface_block<Planned>}, {block_of<draft<Planned>.files[I]>}..., {block<1>{{'\0'}}}});
    }

    template <const auto* Planned>
    static constexpr auto text = join<Planned>(std::make_index_sequence<draft<Planned>.files.size()>{});

    template <std::size_t... I>
    static constexpr std::array<pass, pass_count> list_passes(std::index_sequence<I...>) {
        return {described<&planned.passes.items[I]>()...};
    }

    template <std::size_t... I>
    static constexpr std::array<capture, sizeof...(I)> list_captures(std::index_sequence<I...>) {
        return {described<&planned.captures.items[I]>()...};
    }

public:
    /// What the host's geometry pass fills before the passes run; none for most effects.
    static constexpr auto captures = list_captures(std::make_index_sequence<planned.captures.size()>{});

    /// The passes in the order of execution.
    static constexpr std::array<pass, pass_count> passes =
        list_passes(std::make_index_sequence<pass_count>{});

    /// The resources that the passes use; 0 is the block of parameters, the outputs are the last.
    static constexpr auto resources = joining::shrink<planned.resources.size()>(planned.resources);

    /// The device features that all passes together require.
    static constexpr device_features features = required_features(planned);

    /// The settings as the parts recommend them; the host adds the view (`set_projection`) and the radius.
    static constexpr parameters defaults =
        default_parameters({planned.choices.data(), planned.choices.size()});

    /// The whole text of a pass, NUL-terminated, with static storage; made only where it is named.
    template <std::size_t Pass>
    static constexpr std::string_view source{text<&planned.passes.items[Pass]>.data(),
                                             text<&planned.passes.items[Pass]>.size() - 1};

    /// The whole text of a capture, likewise.
    template <std::size_t Capture>
    static constexpr std::string_view capture_source{text<&planned.captures.items[Capture]>.data(),
                                                     text<&planned.captures.items[Capture]>.size() - 1};

    /// The effect as data, for a renderer.
    static constexpr effect_view view() { return {captures, passes, resources, features, defaults}; }
    constexpr operator effect_view() const { return view(); }
};

}
