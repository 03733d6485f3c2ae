// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/assertions.hpp>
#include <crease/compose/described.hpp>
#include <crease/compose/joining.hpp>
#include <crease/compose/preset.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace crease {

// All of it stands outside of classes, as a compiler goes through the templates in a class for each of its
// instances, and is variables, as it evaluates a function that returns what it calls once more to warn of it.
namespace composing {

/// The list without its unused places.
template <std::size_t Count, class Item, std::size_t Capacity>
constexpr std::array<Item, Count> shrink(const fixed_list<Item, Capacity>& list) {
    std::array<Item, Count> all{};
    for (std::size_t i = 0; i < Count; ++i)
        all[i] = list[i];
    return all;
}

template <class Effect>
inline constexpr plan planned = Effect::is_legal ? make_plan(Effect::choices) : plan{};

template <class Effect, std::size_t Pass>
inline constexpr auto files = files_of(planned<Effect>, planned<Effect>.passes[Pass]);

template <class Effect, std::size_t Pass, class Files>
struct symbols;
template <class Effect, std::size_t Pass, std::size_t... File>
struct symbols<Effect, Pass, std::index_sequence<File...>> {
    static constexpr const symbol_table* tables[] = {&symbols_of<files<Effect, Pass>.items[File]>...};
};

template <class Effect, std::size_t Pass>
inline constexpr program written =
    write_program(planned<Effect>, planned<Effect>.passes[Pass],
                  symbols<Effect, Pass, std::make_index_sequence<files<Effect, Pass>.size()>>::tables,
                  files<Effect, Pass>.cut);

template <std::size_t Words>
struct packed {
    std::uint64_t words[Words];
};
template <std::size_t Words>
struct unpacked {
    char characters[8 * Words];
};

template <std::size_t Words>
constexpr unpacked<Words> unpack(const interface_text& text) {
    packed<Words> all{};
    for (std::size_t i = 0; i < Words; ++i)
        all.words[i] = text.words[i];
    return std::bit_cast<unpacked<Words>>(all);
}

/// The characters of a program's interface, filled up with zeros.
template <class Effect, std::size_t Pass>
inline constexpr auto head = unpack<(written<Effect, Pass>.head.size() + 7) / 8>(written<Effect, Pass>.head);

template <class Effect, std::size_t Pass>
inline constexpr auto pieces = [] {
    std::array<piece, piece_count(written<Effect, Pass>)> all{};
    list_pieces(written<Effect, Pass>, head<Effect, Pass>.characters, all.data());
    return all;
}();

/// Asserts that the passes fit each other, each rule with the effect that it is about.
template <class Effect, class Whole>
constexpr bool assert_fit() {
    constexpr refusal refused = planned<Effect>.refused ? planned<Effect>.refused : Whole::misfit;
    return rules::assert_resource_once<refused.sentence != rules::resource_once, Effect>() &&
           rules::assert_known_resource<refused.sentence != rules::known_resource, Effect>() &&
           rules::assert_written_first<refused.sentence != rules::written_first, Effect>() &&
           rules::assert_few_resources<refused.sentence != rules::few_resources, Effect>() &&
           rules::assert_few_passes<refused.sentence != rules::few_passes, Effect>() &&
           rules::assert_short_programs<refused.sentence != rules::short_programs, Effect>();
}

template <class Effect, class Passes>
struct whole;
template <class Effect, std::size_t... Pass>
struct whole<Effect, std::index_sequence<Pass...>> {
    static constexpr resource_map map = [] {
        resource_map used;
        (used.use(written<Effect, Pass>), ...);
        used.number(planned<Effect>);
        return used;
    }();
    static constexpr refusal misfit = [] {
        pass_order order;
        refusal first;
        ((first = first ? first
                        : order.next(planned<Effect>, planned<Effect>.passes[Pass], written<Effect, Pass>)),
         ...);
        return first;
    }();
    template <std::size_t Which>
    static constexpr auto bindings = [] {
        auto all = shrink<written<Effect, Which>.bindings.size()>(written<Effect, Which>.bindings);
        for (binding& b : all)
            b.resource = map.index[b.resource];
        return all;
    }();
    template <std::size_t Which>
    static constexpr auto
        constants = shrink<written<Effect, Which>.constants.size()>(written<Effect, Which>.constants);

    template <std::size_t Which>
    static constexpr pass described() {
        pass own = describe(planned<Effect>, planned<Effect>.passes[Which]);
        own.pieces = pieces<Effect, Which>;
        own.bindings = bindings<Which>;
        own.constants = constants<Which>;
        return own;
    }
    // A member that nothing names is never asserted.
    static constexpr bool fits = assert_fit<Effect, whole>();
    static constexpr std::array<pass, sizeof...(Pass)> passes = [] {
        std::array<pass, sizeof...(Pass)> all{};
        if constexpr (fits)
            all = {described<Pass>()...};
        return all;
    }();
    static constexpr std::array<resource, map.count> resources = [] {
        std::array<resource, map.count> all{};
        for (std::size_t i = 0; fits && i < planned<Effect>.resources.size(); ++i)
            if (map.is_used[i])
                all[map.index[i]] = describe(planned<Effect>.resources[i]);
        return all;
    }();
};

template <class Effect>
using all_of = whole<Effect, std::make_index_sequence<planned<Effect>.passes.size()>>;

template <class Effect>
inline constexpr auto settings = shrink<planned<Effect>.settings.size()>(planned<Effect>.settings);

// A copy of its own, as naming the plan would keep all that the parts describe.
template <class Effect>
inline constexpr auto recipe_name = recipe_text(Effect::choices);

/// A text as a template argument.
template <std::size_t Size>
struct name {
    char characters[Size];
    consteval name(const char (&literal)[Size]) {
        for (std::size_t i = 0; i < Size; ++i)
            characters[i] = literal[i];
    }
    constexpr std::string_view view() const { return {characters, Size - 1}; }
};

template <name Name, class Effect>
constexpr bool has_setting() {
    for (const effect_setting& s : settings<Effect>)
        if (s.is(Name.view()))
            return true;
    return false;
}

}

template <class First, class... Rest>
struct effect;

namespace composing {

template <std::size_t At, class Part>
struct placed {
    using type = Part;
};
template <std::size_t At, class Part>
placed<At, Part> part_at(const placed<At, Part>&);

template <class Places, class... Parts>
struct all_placed;
template <std::size_t... At, class... Parts>
struct all_placed<std::index_sequence<At...>, Parts...> : placed<At, Parts>... {};

/// The effect of a preset's parts and those named behind it.
template <class Parts, class... Named>
struct preset_effect;
template <class... Parts, class... Named>
struct preset_effect<part_list<Parts...>, Named...> {
    using all = all_placed<std::index_sequence_for<Parts..., Named...>, Parts..., Named...>;
    static constexpr auto places = [] {
        const choice named[] = {choice{}, rules::choice_or_none<Named>()...};
        return combining::order(choices_in<part_list<Parts...>>, {named + 1, sizeof...(Named)});
    }();
    template <std::size_t... I>
    static effect<typename decltype(part_at<places[I]>(all{}))::type...> chosen(std::index_sequence<I...>);
    using type = decltype(chosen(std::make_index_sequence<places.size()>{}));
};

}

/// An ambient-occlusion effect, composed at compile time.
///
/// The first three parts, a sampler, a depth source and an estimator, make the main pass; the rest are
/// filters, in the order in which they run, and the view parts, the stage and the dialect, where they differ
/// from the defaults (perspective, device_depth, given_normals, hashed_noise, visibility_only, compute,
/// vulkan_glsl). In place of the three may stand a preset, as in `effect<preset::medium, bent_cone>`: the
/// parts behind it take the place of those of the preset that have the same role. Parts that do not fit fail
/// to compile, with one sentence.
template <class First, class... Rest>
struct effect {
    /// Asserted: whether the parts make an effect.
    static constexpr bool is_legal = rules::assert_all<First, Rest...>();

    /// The parts with their numbers: a `recipe` of them is the same effect at run time.
    static constexpr choice choices[] = {rules::choice_or_none<First>(), rules::choice_or_none<Rest>()...};

    /// The passes in the order of execution, geometry passes of the host among them.
    static constexpr const auto& passes = composing::all_of<effect>::passes;

    /// The resources that the passes use; 0 is the block of parameters, the outputs are the last.
    static constexpr const auto& resources = composing::all_of<effect>::resources;

    /// The settings of the parts, in the order of the block of parameters.
    static constexpr const auto& settings = composing::settings<effect>;

    /// The device features that all passes together require.
    static constexpr device_features features = required_features(composing::planned<effect>);

    /// The settings as the parts recommend them; the host adds the view (`set_projection`) and the radius.
    static constexpr parameters defaults = default_parameters(composing::settings<effect>);

    /// Sets a setting, named as in "strength" or "hbao.bias".
    /// @return false, with `p` unchanged, where the value is out of its range
    template <composing::name Name>
    static constexpr bool set(parameters& p, float value) {
        static_assert(composing::has_setting<Name, effect>(),
                      "crease::effect: none of the parts has a setting of that name");
        return crease::set(p, composing::settings<effect>, Name.view(), value);
    }

    /// The bytes of the uniform block.
    static auto block(const parameters& p) {
        std::array<std::byte,
                   block_size(composing::planned<effect>.views, composing::settings<effect>.size())>
            bytes{};
        write_block(p, composing::planned<effect>.views, composing::settings<effect>.size(), bytes.data());
        return bytes;
    }

    /// The whole text of a pass, NUL-terminated, with static storage; joined where it is first called for.
    template <std::size_t Pass>
    static std::string_view source() {
        static char characters[joining::size_of(composing::pieces<effect, Pass>) + 1];
        static const std::string_view whole = joining::join(composing::pieces<effect, Pass>, characters);
        return whole;
    }

    /// The effect as data, for a renderer.
    static constexpr effect_view view() {
        return {passes,
                resources,
                settings,
                composing::planned<effect>.views,
                features,
                defaults,
                composing::recipe_name<effect>.view()};
    }
    /// The same, without a word: an effect is passed where its data is asked for.
    constexpr operator effect_view() const { return view(); }
};

// The effect of a preset is that of its parts.
template <a_preset Preset, class... Rest>
struct effect<Preset, Rest...> : composing::preset_effect<typename Preset::parts, Rest...>::type {};

}
