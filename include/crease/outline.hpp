// SPDX-License-Identifier: MIT
#pragma once

#include <crease/joining.hpp>
#include <crease/program.hpp>

#include <array>
#include <cstddef>
#include <utility>

namespace crease {

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

/// The parameters with each part's recommended settings, and no view yet.
constexpr parameters default_parameters(array_view<const choice> choices) {
    parameters p;
    for (const choice& c : choices)
        for (const setting& s : c.what->settings)
            p.*s.field = s.fallback;
    return p;
}

/// The list without its unused places.
template <std::size_t Count, class Item, std::size_t Capacity>
constexpr std::array<Item, Count> shrink(const fixed_list<Item, Capacity>& list) {
    std::array<Item, Count> all{};
    for (std::size_t i = 0; i < Count; ++i)
        all[i] = list[i];
    return all;
}

/// What a compiler takes long for, once for all effects with the same `outlined_parts`. All of it stands
/// outside of classes, as the templates in a class are gone through for each of its instances.
namespace outlining {

// Variables and not functions that return what they call: a compiler evaluates that once more to warn of it.
template <class Parts>
inline constexpr plan planned = make_plan(Parts::parts);
// Of parts that make no effect: no second error after the assertion's.
template <>
inline constexpr plan planned<void> = {};

template <class Parts>
inline constexpr std::size_t capture_count = planned<Parts>.captures.size();

template <class Parts>
inline constexpr std::size_t pass_count = planned<Parts>.passes.size();

template <class Parts>
inline constexpr auto resources = shrink<planned<Parts>.resources.size()>(planned<Parts>.resources);

template <class Parts>
inline constexpr device_features features = required_features(planned<Parts>);

template <class Parts>
inline constexpr parameters defaults = default_parameters(planned<Parts>.choices);

/// Programs are counted over the captures and then the passes.
template <class Parts, std::size_t Program>
constexpr const auto& planned_program() {
    if constexpr (Program < capture_count<Parts>)
        return planned<Parts>.captures[Program];
    else
        return planned<Parts>.passes[Program - capture_count<Parts>];
}

template <class Parts, std::size_t Program>
inline constexpr program draft = write_program(planned<Parts>, planned_program<Parts, Program>());

template <class Parts, std::size_t Program>
inline constexpr auto
    bindings = shrink<draft<Parts, Program>.bindings.size()>(draft<Parts, Program>.bindings);

/// The open numbers of a program's interface, and where they stand in it.
template <class Parts, std::size_t Program>
inline constexpr auto
    gaps = shrink<draft<Parts, Program>.interface.gaps().size()>(draft<Parts, Program>.interface.gaps());

template <class Parts, std::size_t Program>
inline constexpr auto interface_block =
    draft<Parts, Program>.interface.template first<draft<Parts, Program>.interface.size()>();

template <class Parts, std::size_t Program, class Gaps>
struct interface_runs;
template <class Parts, std::size_t Program, std::size_t... Gap>
struct interface_runs<Parts, Program, std::index_sequence<Gap...>> {
    template <std::size_t Place>
    using before = joining::block<gaps<Parts, Program>[Place].before>;
    using last = joining::block<draft<Parts, Program>.interface.after_gaps()>;
    using blocks = joining::sequence<before<Gap>..., last>;
    static constexpr blocks value = __builtin_bit_cast(blocks, interface_block<Parts, Program>);
};

/// The characters of a program's interface before its gaps and after them.
template <class Parts, std::size_t Program>
using runs = interface_runs<Parts, Program, std::make_index_sequence<gaps<Parts, Program>.size()>>;

template <class Parts, std::size_t Program, std::size_t First, class Places>
struct files_from;
template <class Parts, std::size_t Program, std::size_t First, std::size_t... I>
struct files_from<Parts, Program, First, std::index_sequence<I...>> {
    using type = joining::file_group<draft<Parts, Program>.files.items[First + I]...>;
};

constexpr std::size_t least(std::size_t one, std::size_t other) {
    return one < other ? one : other;
}

/// The files of a program, a group at a time.
template <class Parts, std::size_t Program, std::size_t Group,
          std::size_t First = Group* joining::files_in_group>
using file_group =
    typename files_from<Parts, Program, First,
                        std::make_index_sequence<least(draft<Parts, Program>.files.size() - First,
                                                       joining::files_in_group)>>::type;

template <class Parts, std::size_t Program>
using file_groups =
    std::make_index_sequence<(draft<Parts, Program>.files.size() + joining::files_in_group - 1) /
                             joining::files_in_group>;

}

}
