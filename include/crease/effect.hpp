// SPDX-License-Identifier: MIT
#pragma once

#include <crease/program.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace crease {

/// The parameters with each part's recommended settings, and no view yet.
constexpr parameters default_parameters(array_view<const choice> choices) {
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
    for (const choice& c : p.choices)
        required |= c.what->features;
    for (const planned_capture& c : p.captures) {
        required.fragment_stores_and_atomics |= vulkan && c.what->how == access::modify;
        const resource& filled = p.resources[c.output];
        if (c.what->how == access::attachment)
            required.depth_samples |= filled.samples;
        if (filled.centred)
            required.centred_depth_samples |= filled.samples;
    }
    for (const planned_pass& pass : p.passes)
        if (vulkan && writing::stage_of(p, pass) == stage_kind::compute)
            for (unsigned output : pass.outputs)
                required.extended_storage_formats |= facts_of(p.resources[output].texels).extended;
    return required;
}

namespace joining {

template <std::size_t Size>
struct characters {
    char items[Size];
};

template <std::size_t Size>
constexpr characters<Size> write(const interface_text& text) {
    characters<Size> all{};
    text.write(all);
    return all;
}

// A block is text in few items, as a compiler copies and checks the items of constants one by one.
#pragma pack(push, 1)
template <std::size_t Size, std::size_t Words = Size / 8, std::size_t Rest = Size % 8>
struct block {
    std::uint64_t words[Words];
    char rest[Rest];
};
template <std::size_t Size, std::size_t Words>
struct block<Size, Words, 0> {
    std::uint64_t words[Words];
};
template <std::size_t Size, std::size_t Rest>
struct block<Size, 0, Rest> {
    char rest[Rest];
};
#pragma pack(pop)

struct eight {
    char characters[8];
};

template <std::size_t Size>
constexpr block<Size> block_at(const char* from) {
    block<Size> all{};
    if constexpr (Size >= 8)
        for (std::size_t i = 0; i < Size / 8; ++i, from += 8)
            all.words[i] = std::bit_cast<std::uint64_t>(
                eight{{from[0], from[1], from[2], from[3], from[4], from[5], from[6], from[7]}});
    if constexpr (Size % 8 != 0)
        for (std::size_t i = 0; i < Size % 8; ++i)
            all.rest[i] = from[i];
    return all;
}

// A block per place, as a type may be a base only once.
template <std::size_t, class Block>
struct placed : Block {};

template <class... Blocks>
struct joined : Blocks... {};

// Never copied to characters, which would take a compiler longer than all else together.
template <class Blocks>
union text_of {
    Blocks blocks;
    char characters[sizeof(Blocks)];
};

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
inline constexpr auto block_of = block_at<File->text.size()>(File->text.data());

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
            return make_plan({chosen, 3 + sizeof...(Rest)});
        } else {
            return plan{}; // no second error after the assertion's
        }
    }

    static constexpr plan planned = make();

    static constexpr std::size_t capture_count = planned.captures.size(), pass_count = planned.passes.size();

    /// Programs are counted over the captures and then the passes.
    template <std::size_t Program>
    static constexpr const auto& planned_program() {
        if constexpr (Program < capture_count)
            return planned.captures[Program];
        else
            return planned.passes[Program - capture_count];
    }

    template <std::size_t Program>
    static constexpr program draft = write_program(planned, planned_program<Program>());

    template <std::size_t Program>
    static constexpr auto
        interface_characters = joining::write<draft<Program>.interface.size()>(draft<Program>.interface);

    template <std::size_t Program>
    static constexpr glsl_file interface_piece{
        "interface", std::string_view(interface_characters<Program>.items, draft<Program>.interface.size())};

    template <std::size_t Program, std::size_t... I>
    static constexpr std::array<piece, 1 + sizeof...(I)> list_pieces(std::index_sequence<I...>) {
        return {interface_piece<Program>, *draft<Program>.files[I]...};
    }

    template <std::size_t Program>
    static constexpr auto
        pieces_of = list_pieces<Program>(std::make_index_sequence<draft<Program>.files.size()>{});

    template <std::size_t Program>
    static constexpr auto
        bindings_of = joining::shrink<draft<Program>.bindings.size()>(draft<Program>.bindings);

    template <std::size_t Program>
    static constexpr auto
        constants_of = joining::shrink<draft<Program>.constants.size()>(draft<Program>.constants);

    /// A pass or a capture with its lists.
    template <std::size_t Program>
    static constexpr auto described() {
        auto whole = describe(planned, planned_program<Program>());
        whole.pieces = pieces_of<Program>;
        whole.bindings = bindings_of<Program>;
        whole.constants = constants_of<Program>;
        return whole;
    }

    template <std::size_t Program>
    using interface_block = joining::block<draft<Program>.interface.size()>;

    template <std::size_t Program, std::size_t... I>
    using joined_blocks =
        joining::joined<joining::placed<0, interface_block<Program>>,
                        joining::placed<1 + I, joining::block<draft<Program>.files[I]->text.size()>>...,
                        joining::placed<1 + sizeof...(I), joining::block<1>>>;

    // A variable and the operator behind std::bit_cast: a compiler copies the results and arguments of calls.
    template <std::size_t Program, std::size_t... I>
    static constexpr joining::text_of<joined_blocks<Program, I...>> joined_text{
        {{__builtin_bit_cast(interface_block<Program>, interface_characters<Program>)},
         {joining::block_of<draft<Program>.files[I]>}...,
         {joining::block<1>{{'\0'}}}}};

    template <std::size_t Program, std::size_t... I>
    static constexpr std::string_view join(std::index_sequence<I...>) {
        return {joined_text<Program, I...>.characters, sizeof(joined_text<Program, I...>) - 1};
    }

    template <std::size_t Program>
    static constexpr std::string_view
        text = join<Program>(std::make_index_sequence<draft<Program>.files.size()>{});

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
    static constexpr auto resources = joining::shrink<planned.resources.size()>(planned.resources);

    /// The device features that all passes together require.
    static constexpr device_features features = required_features(planned);

    /// The settings as the parts recommend them; the host adds the view (`set_projection`) and the radius.
    static constexpr parameters defaults = default_parameters(planned.choices);

    /// The whole text of a pass, NUL-terminated, with static storage; made only where it is named. Its
    /// characters are read at run time, as they are kept in words; constant expressions read `pieces`.
    template <std::size_t Pass>
    static constexpr std::string_view source = text<capture_count + Pass>;

    /// The whole text of a capture, likewise.
    template <std::size_t Capture>
    static constexpr std::string_view capture_source = text<Capture>;

    /// The effect as data, for a renderer.
    static constexpr effect_view view() { return {captures, passes, resources, features, defaults}; }
    constexpr operator effect_view() const { return view(); }
};

}
