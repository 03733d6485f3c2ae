// SPDX-License-Identifier: MIT
#pragma once

#include <crease/joining.hpp>
#include <crease/program.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
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

/// An effect without its open numbers: all that a compiler takes long for, once for the effects that differ
/// only in these.
/// @tparam OpenParts  an `outlined_parts`
template <class OpenParts>
struct outline {
    static constexpr plan make() {
        if constexpr (requires { OpenParts::parts; })
            return make_plan(OpenParts::parts);
        else
            return plan{};
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

    /// The open numbers of a program's interface, and where they stand in it.
    template <std::size_t Program>
    static constexpr auto gaps = shrink<draft<Program>.interface.gaps().size()>(draft<Program>.interface.gaps());

    template <std::size_t Program>
    static constexpr std::size_t file_count = draft<Program>.files.size();

    template <std::size_t Program>
    static constexpr auto bindings = shrink<draft<Program>.bindings.size()>(draft<Program>.bindings);

    static constexpr auto resources = shrink<planned.resources.size()>(planned.resources);

    static constexpr device_features features = required_features(planned);

    static constexpr parameters defaults = default_parameters(planned.choices);

    /// Where a run of the interface's characters ends: at a gap, or at the end of all.
    template <std::size_t Program>
    static constexpr std::size_t end_of_run(std::size_t run) {
        return run < gaps<Program>.size() ? gaps<Program>[run].at : draft<Program>.interface.size();
    }

    template <std::size_t Program, std::size_t Run>
    static constexpr std::size_t
        run_size = end_of_run<Program>(Run) - (Run == 0 ? 0 : end_of_run<Program>(Run - 1));

    template <std::size_t Program>
    static constexpr auto write_interface() {
        joining::characters<draft<Program>.interface.size()> all{};
        draft<Program>.interface.write(all);
        return all;
    }

    template <std::size_t Program>
    static constexpr auto interface_characters = write_interface<Program>();

    template <std::size_t Program, std::size_t... Run>
    static constexpr auto split(std::index_sequence<Run...>) {
        using runs = joining::joined<joining::placed<Run, joining::block<run_size<Program, Run>>>...>;
        return __builtin_bit_cast(runs, interface_characters<Program>);
    }

    template <std::size_t Program>
    static constexpr auto runs = split<Program>(std::make_index_sequence<gaps<Program>.size() + 1>{});

    template <std::size_t Program, std::size_t First, std::size_t... I>
    static constexpr const auto& join_some(std::index_sequence<I...>) {
        return joining::joined_files<draft<Program>.files[First + I]...>;
    }

    /// Files in groups, as one outline has most groups of another.
    template <std::size_t Program, std::size_t Group>
    static constexpr const auto& group() {
        constexpr std::size_t first = Group * joining::group_size, rest = file_count<Program> - first;
        return join_some<Program, first>(
            std::make_index_sequence<(rest < joining::group_size ? rest : joining::group_size)>{});
    }

    template <std::size_t Program, std::size_t... Group>
    using blocks_of_groups =
        joining::joined<joining::placed<Group, std::remove_cvref_t<decltype(group<Program, Group>())>>...,
                        joining::placed<sizeof...(Group), joining::block<1>>>;

    // A variable: a compiler copies the results and arguments of calls.
    template <std::size_t Program, std::size_t... Group>
    static constexpr blocks_of_groups<Program, Group...> joined_groups{{group<Program, Group>()}...,
                                                                       {joining::block<1>{{'\0'}}}};

    template <std::size_t Program, std::size_t... Group>
    static constexpr const auto& join_groups(std::index_sequence<Group...>) {
        return joined_groups<Program, Group...>;
    }

    /// The characters of a program's interface before its gap `Run`, or after all gaps.
    template <std::size_t Program, std::size_t Run>
    using run_block = joining::block<run_size<Program, Run>>;
    template <std::size_t Program, std::size_t Run>
    static constexpr const run_block<Program, Run>& run() {
        return static_cast<const joining::placed<Run, run_block<Program, Run>>&>(runs<Program>);
    }

    /// The files of a program, NUL-terminated.
    template <std::size_t Program>
    static constexpr const auto& files() {
        return join_groups<Program>(
            std::make_index_sequence<(file_count<Program> + joining::group_size - 1) / joining::group_size>{});
    }
};

}
