// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>
#include <crease/compose/refusal.hpp>
#include <crease/effect/array_view.hpp>
#include <crease/effect/fixed_list.hpp>
#include <crease/parts/defaults.hpp>
#include <crease/parts/reads/image_load.hpp>
#include <crease/parts/stage/compute_strips.hpp>
#include <crease/parts/stage/stages.hpp>

#include <cstddef>
#include <string_view>

namespace crease {

/// The most parts that an effect may consist of, those filled in by default included.
inline constexpr std::size_t most_parts = 36;

/// The most of these that may be named: the others are left to defaults.
inline constexpr std::size_t most_chosen = 16;

/// The parts of an effect in order: sampler, depth source, estimator, and then the rest.
using choice_list = fixed_list<choice, most_parts>;

namespace rules {

constexpr bool numbers_in_range(const choice& c) {
    for (std::size_t i = 0; i < c.what->numbers.size(); ++i)
        if (c.numbers[i] < c.what->numbers[i].least || c.numbers[i] > c.what->numbers[i].most)
            return false;
    return true;
}

/// Whether an effect has a part of a role only where another part requires one.
constexpr bool is_on_request(role r) {
    return r == role::coverage || r == role::layer_storage || r == role::scan;
}

constexpr bool requires_role(array_view<const choice> choices, role wanted) {
    for (const choice& c : choices)
        for (role r : c.what->required_roles)
            if (r == wanted)
                return true;
    return false;
}

constexpr bool may_follow_three(role r) {
    return r != role::sampler && r != role::depth_source && r != role::estimator;
}

/// The part's factor between the resolutions of its input and its output; 1 where it has none.
constexpr unsigned upsampling_of(const choice& c) {
    for (const step& s : c.what->steps)
        if (s.upsampling >= 0)
            return static_cast<unsigned>(c.numbers[s.upsampling]);
    return 1;
}

constexpr bool takes_full_size(const choice& c) {
    for (const step& s : c.what->steps)
        if (s.full_size_input)
            return true;
    return false;
}

/// Whether no later filter, nor this one, makes the picture larger than the input of `choices[at]`.
constexpr bool input_is_full_size(array_view<const choice> choices, std::size_t at) {
    for (std::size_t i = at; i < choices.size(); ++i)
        if (upsampling_of(choices[i]) != 1)
            return false;
    return true;
}

/// The first trait that a part needs and one of the others of its role does not offer; null where all fit.
constexpr const trait* unmet(const part& p, array_view<const choice> choices) {
    for (const trait* needed : p.needs)
        for (const choice& other : choices)
            if (other.what->kind == needed->from && !has(other.what->offers, needed))
                return needed;
    return nullptr;
}

/// Whether a part offers what the others need of its role.
constexpr bool suits(const part& p, array_view<const choice> choices) {
    for (const choice& other : choices)
        for (const trait* needed : other.what->needs)
            if (needed->from == p.kind && !has(p.offers, needed))
                return false;
    return true;
}

}

/// Adds the default part of each role that only has to be named where it differs: the first that fits.
constexpr choice_list complete(array_view<const choice> choices) {
    choice_list all;
    bool has_role[role_count]{};
    for (const choice& c : choices) {
        all.add(c);
        has_role[static_cast<unsigned>(c.what->kind)] = true;
    }
    for (const choice& fallback : default_choices) {
        bool& is_there = has_role[static_cast<unsigned>(fallback.what->kind)];
        if (is_there || (rules::is_on_request(fallback.what->kind) &&
                         !rules::requires_role(choices, fallback.what->kind)))
            continue;
        if (rules::unmet(*fallback.what, choices) || !rules::suits(*fallback.what, choices))
            continue;
        all.add(fallback);
        is_there = true;
    }
    return all;
}

namespace rules {

/// Why the stage cannot keep layers in shared memory.
/// @param choices  of which the second is the depth source
constexpr refusal check_strips(array_view<const choice> choices, const choice& stage) {
    unsigned divisor = 1;
    for (const choice& c : choices) {
        divisor *= upsampling_of(c);
        if (has(c.what->needs, &layers_with_opacity::value))
            return {strips_of_depths, stage.what->name, c.what->name};
    }
    if (strip_bytes(stage, choices[1], divisor) > most_shared_bytes)
        return {small_strips, stage.what->name, choices[1].what->name};
    return {};
}

/// Why GLSL ES or WebGPU cannot what the parts do.
/// @param all  with the parts of all roles
constexpr refusal check_dialect(const choice_list& all, const choice& dialect) {
    const bool is_es = dialect_of(*dialect.what) == dialect_kind::glsl_es;
    const int asked = dialect.number_of("version");
    if (is_es && asked != 300 && asked != 310)
        return {es_versions, dialect.what->name};
    for (const choice& c : all) {
        if (asked == 300 && c.what->kind == role::stage && stage_of(*c.what) == stage_kind::compute)
            return {es_fragments, c.what->name, dialect.what->name};
        if (asked == 300 && has(c.what->offers, &image_loads::value))
            return {es_loads, c.what->name, dialect.what->name};
        if (c.what->features.subgroup_arithmetic)
            return {es_subgroups, c.what->name, dialect.what->name};
        for (const step& s : c.what->steps) {
            if (s.kind == step_kind::result || c.numbers[0] < s.from)
                continue;
            if (s.kind == step_kind::geometry)
                return {es_layers, c.what->name, dialect.what->name};
            if (asked == 300)
                return {es_fragments, c.what->name, dialect.what->name};
        }
    }
    return {};
}

}

/// Checks parts chosen at run time by the same rules as `effect` does at compile time.
constexpr refusal check(array_view<const choice> choices) {
    if (choices.size() > most_chosen)
        return {rules::few_enough, choices[most_chosen].what->name};
    constexpr role first_three[] = {role::sampler, role::depth_source, role::estimator};
    constexpr std::string_view sentences[] = {rules::sampler_first, rules::depth_source_second,
                                              rules::estimator_third};
    for (std::size_t i = 0; i < 3; ++i)
        if (i >= choices.size() || choices[i].what->kind != first_three[i])
            return {sentences[i], i < choices.size() ? choices[i].what->name : "there is none"};
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const part& p = *choices[i].what;
        if (i >= 3 && !rules::may_follow_three(p.kind))
            return {rules::rest_beside_three, p.name};
        for (std::size_t j = 3; j < i; ++j)
            if (p.kind != role::filter && choices[j].what->kind == p.kind)
                return {rules::role_once, choices[j].what->name, p.name};
        if (!rules::numbers_in_range(choices[i]))
            return {rules::in_range, p.name};
        if (rules::is_on_request(p.kind) && !rules::requires_role(choices, p.kind))
            return {rules::asked_for, p.name, choices[1].what->name};
        if (const trait* needed = rules::unmet(p, choices))
            for (const choice& other : choices)
                if (other.what->kind == needed->from)
                    return {needed->sentence, p.name, other.what->name};
        if (rules::takes_full_size(choices[i]) && !rules::input_is_full_size(choices, i))
            return {rules::full_size_input, p.name};
    }
    for (const choice& c : choices)
        if (has(c.what->needs, &layers_in_strips::value))
            if (const refusal refused = rules::check_strips(choices, c))
                return refused;
    for (const choice& c : choices) {
        if (c.what->kind != role::dialect)
            continue;
        const dialect_kind kind = dialect_of(*c.what);
        if (kind == dialect_kind::glsl_es || kind == dialect_kind::webgpu)
            return rules::check_dialect(complete(choices), c);
    }
    return {};
}

/// The recipe of parts as text, with all numbers: `NAME[:NxN...]/...`.
constexpr fixed_text<512> recipe_text(array_view<const choice> choices) {
    fixed_text<512> out;
    for (const choice& c : choices) {
        out << (out.count ? "/" : "") << c.what->name;
        for (std::size_t i = 0; i < c.what->numbers.size(); ++i)
            out << (i == 0 ? ":" : "x") << c.numbers[i];
    }
    return out;
}

}
