// SPDX-License-Identifier: MIT
#pragma once

#include <crease/contract.hpp>
#include <crease/encoding.hpp>

#include <crease/core/files.hpp>

namespace crease {

/// The most passes and resources that an effect may have.
inline constexpr std::size_t most_passes = 32, most_resources = 48;

/// A pass before its text: which step of which part, and between which resources.
struct planned_pass {
    const step* what = nullptr;
    choice owner{};                   ///< the part whose step it is; of the main pass the estimator
    int input = -1;                   ///< resource that a filter reads; -1: none
    unsigned output = 0;              ///< resource that it writes
    const encoding* result = nullptr; ///< how it writes it
    unsigned divisor = 1, input_divisor = 1;
};

/// An effect before its text.
struct plan {
    choice_list choices;
    fixed_list<planned_pass, most_passes> passes;
    fixed_list<resource, most_resources> resources;

    constexpr const choice& chosen(role r) const {
        for (const choice& c : choices)
            if (c.what->kind == r)
                return c;
        return choices[0];
    }
    constexpr unsigned index_of(std::string_view resource_name) const {
        unsigned i = 0;
        while (resources[i].name != resource_name)
            ++i;
        return i;
    }
    constexpr void add_resource(const resource& wanted) {
        for (const resource& r : resources)
            if (r.name == wanted.name)
                return;
        resources.add(wanted);
    }
};

/// The roles whose functions the main pass calls, in the order of their text.
inline constexpr role main_roles[] = {role::projection, role::depth_encoding, role::depth_source,
                                      role::normals,    role::sampler,        role::estimator};

inline constexpr step main_step{.name = "visibility", .body = &visibility_glsl, .includes = main_roles};

namespace planning {

// Images between passes need names with static storage.
inline constexpr std::string_view intermediate[] = {"between_0",  "between_1",  "between_2",  "between_3",
                                                    "between_4",  "between_5",  "between_6",  "between_7",
                                                    "between_8",  "between_9",  "between_10", "between_11",
                                                    "between_12", "between_13", "between_14", "between_15"};

constexpr void add_inputs(plan& p, std::span<const role> includes) {
    for (role r : includes)
        for (const resource& wanted : p.chosen(r).what->resources)
            p.add_resource(wanted);
}

/// The chain of steps that hand a visibility on: the main pass, and then those of the filters.
constexpr void add_chain(plan& p) {
    unsigned divisor = 1;
    for (const choice& c : p.choices)
        divisor *= rules::upsampling_of(c);
    const planned_pass main_pass{
        .what = &main_step, .owner = p.chosen(role::estimator), .divisor = divisor, .input_divisor = divisor};
    p.passes.add(main_pass);
    for (const choice& c : p.choices)
        if (c.what->kind == role::filter)
            for (const step& s : c.what->steps) {
                const unsigned input_divisor = divisor;
                if (&s == &c.what->steps.back())
                    divisor /= rules::upsampling_of(c);
                p.passes.add({.what = &s, .owner = c, .divisor = divisor, .input_divisor = input_divisor});
            }
}

/// Gives each step of the chain from `first` on an image that is encoded as the next one wants it.
constexpr void connect_chain(plan& p, std::size_t first) {
    for (std::size_t i = first; i < p.passes.size(); ++i) {
        planned_pass& pass = p.passes[i];
        const bool last = i + 1 == p.passes.size();
        pass.result = last ? &visibility_encoding : p.passes[i + 1].what->input;
        p.resources.add({.name = last ? "visibility" : intermediate[i - first],
                         .texels = pass.result->texels,
                         .life = last ? lifetime::output : lifetime::transient,
                         .size = {pass.divisor}});
        pass.output = static_cast<unsigned>(p.resources.size() - 1);
        if (!last)
            p.passes[i + 1].input = static_cast<int>(pass.output);
    }
}

}

/// Plans the effect of parts that `check` accepts.
constexpr plan make_plan(std::span<const choice> choices) {
    plan p{.choices = complete(choices), .passes = {}, .resources = {}};
    p.resources.add({.name = "parameters"});
    const choice& source = p.chosen(role::depth_source);
    planning::add_inputs(p, main_roles);
    for (const step& s : source.what->steps)
        p.passes.add({.what = &s, .owner = source, .output = p.index_of(s.writes)});
    const std::size_t first = p.passes.size();
    planning::add_chain(p);
    for (std::size_t i = first + 1; i < p.passes.size(); ++i)
        planning::add_inputs(p, p.passes[i].what->includes);
    planning::connect_chain(p, first);
    return p;
}

}
