// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/core_files.hpp>
#include <crease/compose/rules.hpp>
#include <crease/effect/parameters.hpp>
#include <crease/effect/pass.hpp>
#include <crease/parts/output/outputs.hpp>
#include <crease/parts/stage/stages.hpp>

namespace crease {

/// The most passes and resources that an effect may have, and the most outputs of a pass.
inline constexpr std::size_t most_passes = 32, most_resources = 48, most_outputs = 8;

/// A pass before its text: which step of which part, and between which resources.
struct planned_pass {
    const step* what = nullptr;
    choice owner{}; ///< the part whose step it is; of the main pass the estimator
    stage_kind stage = stage_kind::compute;
    int input = -1; ///< resource that a filter reads; -1: none
    fixed_list<unsigned, most_outputs> outputs{};
    bool last = false; ///< whether the outputs are the effect's
    extent size{};     ///< of the outputs
    unsigned input_divisor = 1;
    unsigned level = 0;    ///< mip level of the outputs that it writes
    unsigned view = 0;     ///< index of the camera that it works for
    unsigned in_chain = 0; ///< place among the main pass, 0, and those of filters
};

/// An effect before its text.
struct plan {
    choice_list parts; ///< in the order of their roles
    fixed_list<planned_pass, most_passes> passes;
    fixed_list<resource, most_resources> resources; ///< 0 is the block of parameters; of the others those
                                                    ///< that no pass touches do not become the effect's
    fixed_list<effect_setting, most_settings> settings;
    unsigned views = 1;
    fixed_text<512> recipe; ///< the parts that were named, with their numbers
    refusal refused{};

    /// The first part of a role; null where there is none.
    constexpr const choice* find(role r) const {
        for (const choice& c : parts)
            if (c.what->kind == r)
                return &c;
        return nullptr;
    }
    /// The part of a role that every effect has.
    constexpr const choice& chosen(role r) const { return *find(r); }
    constexpr dialect_kind dialect() const { return dialect_of(*chosen(role::dialect).what); }
    constexpr bool is_vulkan() const { return dialect() == dialect_kind::vulkan; }
    /// Whether it is GLSL ES 3.00, which has fragment shaders alone.
    constexpr bool is_glsl_es_300() const {
        return dialect() == dialect_kind::glsl_es && chosen(role::dialect).number_of("version") == 300;
    }

    /// Whether any part needs a trait of another.
    constexpr bool needs(const trait* wanted) const {
        for (const choice& c : parts)
            if (has(c.what->needs, wanted))
                return true;
        return false;
    }

    /// The resource that a camera's pass finds under a name; -1 where there is none.
    constexpr int index_of(std::string_view name, unsigned view) const {
        for (std::size_t i = 0; i < resources.size(); ++i)
            if (resources[i].name == name) {
                const bool is_own = view > 0 && !resources[i].further_names.empty();
                return static_cast<int>(is_own ? i + view : i);
            }
        return -1;
    }
};

inline constexpr step main_step{.name = "visibility"};

namespace planning {

// Images between passes need names with static storage.
inline constexpr std::string_view between[] = {"between_0",  "between_1",  "between_2",  "between_3",
                                               "between_4",  "between_5",  "between_6",  "between_7",
                                               "between_8",  "between_9",  "between_10", "between_11",
                                               "between_12", "between_13", "between_14", "between_15"};

/// Adds the parts in the order of their roles, and those of one role as they come.
constexpr void add_parts(plan& p, const choice_list& all) {
    // Counted and put in place, as a compiler takes its time for each comparison.
    std::size_t places[role_count + 1]{};
    for (const choice& c : all)
        ++places[static_cast<std::size_t>(c.what->kind) + 1];
    for (std::size_t r = 0; r < role_count; ++r)
        places[r + 1] += places[r];
    for (const choice& c : all)
        p.parts.items[places[static_cast<std::size_t>(c.what->kind)]++] = c;
    p.parts.count = all.count;
}

/// Whether the part stands before: a filter that stands twice owns what it describes once, and parts of other
/// roles stand once.
constexpr bool stands_before(const plan& p, const choice& c) {
    if (c.what->kind != role::filter)
        return false;
    for (const choice& each : p.parts)
        if (&each == &c || each.what == c.what)
            return &each != &c;
    return false;
}

/// A resource as the numbers and the parts of the effect make it.
constexpr resource shaped(const plan& p, const choice& owner, const resource& described) {
    resource own = described;
    if (own.shape)
        own.shape(own, {p.parts, owner, p.views});
    own.shape = nullptr;
    return own;
}

constexpr void add_resources(plan& p, const choice& c, unsigned view_divisor) {
    if (stands_before(p, c))
        return;
    for (const resource& described : c.what->resources) {
        if (described.life == lifetime::handed_on || described.life == lifetime::output)
            continue;
        const resource own = shaped(p, c, described);
        if (p.index_of(own.name, 0) >= 0)
            p.refused = {rules::resource_once, c.what->name, own.name};
        p.resources.add(own);
        for (unsigned v = 1; v < p.views && !own.further_names.empty(); ++v) {
            resource further = own;
            further.name = own.further_names[v - 1];
            further.further_names = {};
            further.size = {.divisor = view_divisor};
            p.resources.add(further);
        }
    }
}

constexpr float recommended(const choice& c, const setting& s) {
    for (const setting_value& own : c.settings)
        if (own.name == s.name)
            return own.value;
    return s.fallback;
}

constexpr void add_settings(plan& p, const choice& c) {
    for (const setting& s : c.what->settings) {
        bool is_there = false;
        for (const effect_setting& before : p.settings)
            is_there = is_there || (before.name == s.name &&
                                    ((before.shared && s.shared) || before.part == c.what->name));
        if (!is_there)
            p.settings.add({c.what->name, s.name, recommended(c, s), s.least, s.most, s.meaning, s.shared});
    }
}

/// How often a step runs for a camera: where it runs for further levels, as often as what it writes has them.
constexpr unsigned runs_of(const plan& p, const step& s) {
    if (!s.further_levels)
        return static_cast<unsigned>(s.times);
    const int at = s.writes.empty() ? -1 : p.index_of(s.writes[0], 0);
    const unsigned levels = at < 0 ? 1 : p.resources[static_cast<std::size_t>(at)].levels;
    return levels > s.level ? levels - s.level : 0;
}

/// The steps of a part that run before the main pass or after the last filter.
constexpr void add_steps(plan& p, const choice& owner, bool after, unsigned view_divisor) {
    for (const step& s : owner.what->steps) {
        if (stands_before(p, owner) || s.kind == step_kind::result || s.after != after ||
            owner.numbers[0] < s.from || (s.needed && !p.needs(s.needed)))
            continue;
        const unsigned views = s.per_view ? p.views : 1, runs = runs_of(p, s);
        for (unsigned i = 0; i < views * runs; ++i) {
            planned_pass pass{.what = &s, .owner = owner, .view = i / runs};
            pass.stage = s.kind == step_kind::geometry ? stage_kind::geometry : stage_kind::compute;
            for (std::string_view name : s.writes) {
                const int at = p.index_of(name, pass.view);
                if (at < 0)
                    p.refused = {rules::known_resource, owner.what->name, name};
                else
                    pass.outputs.add(static_cast<unsigned>(at));
            }
            if (pass.outputs.size() > 0)
                pass.size = p.resources[pass.outputs[0]].size;
            if (pass.view > 0)
                pass.size = {.divisor = view_divisor};
            pass.level = s.level + (s.further_levels ? i % runs : 0);
            pass.size.level += pass.level;
            if (pass.outputs.cut)
                p.refused = {rules::few_passes, owner.what->name};
            p.passes.add(pass);
        }
    }
}

/// The passes that hand a result on: the main pass, and then those of the filters.
constexpr void add_chain(plan& p) {
    const stage_kind stage = stage_of(*p.chosen(role::stage).what);
    unsigned divisor = 1;
    for (const choice& c : p.parts)
        divisor *= rules::upsampling_of(c);
    p.passes.add({.what = &main_step,
                  .owner = p.chosen(role::estimator),
                  .stage = stage,
                  .size = {.divisor = divisor},
                  .input_divisor = divisor});
    for (const choice& c : p.parts)
        for (const step& s : c.what->steps) {
            if (s.kind != step_kind::result)
                continue;
            const unsigned input_divisor = divisor;
            if (s.upsampling >= 0)
                divisor /= static_cast<unsigned>(c.numbers[s.upsampling]);
            p.passes.add({.what = &s,
                          .owner = c,
                          .stage = stage,
                          .size = {.divisor = divisor},
                          .input_divisor = input_divisor});
        }
}

/// Gives images that compute passes fill formats that every device can store, where the dialect has no other.
constexpr void widen_stored(plan& p) {
    if (p.dialect() != dialect_kind::glsl_es && p.dialect() != dialect_kind::webgpu)
        return;
    for (const planned_pass& pass : p.passes)
        for (unsigned output : pass.outputs)
            if (pass.stage == stage_kind::compute)
                p.resources[output].texels = facts_of(p.resources[output].texels).stored_by_all;
}

/// Gives each pass of the chain from `first` on what it writes: the last the images that leave the effect.
constexpr void connect_chain(plan& p, std::size_t first) {
    const choice& output = p.chosen(role::output);
    if (p.passes.size() - first > std::size(between)) {
        p.refused = {rules::few_passes, p.chosen(role::estimator).what->name};
        return;
    }
    for (std::size_t i = first; i < p.passes.size(); ++i) {
        planned_pass& pass = p.passes[i];
        pass.last = i + 1 == p.passes.size();
        pass.in_chain = static_cast<unsigned>(i - first);
        for (const resource& described : output.what->resources) {
            if (described.life != (pass.last ? lifetime::output : lifetime::handed_on))
                continue;
            resource own = shaped(p, output, described);
            own.size = pass.size;
            if (!pass.last) {
                own.name = between[i - first];
                own.life = lifetime::transient;
                p.passes[i + 1].input = static_cast<int>(p.resources.size());
            }
            pass.outputs.add(static_cast<unsigned>(p.resources.size()));
            p.resources.add(own);
        }
    }
}

}

/// Plans the effect of parts that `check` accepts.
constexpr plan make_plan(array_view<const choice> choices) {
    plan p;
    p.recipe = recipe_text(choices);
    planning::add_parts(p, complete(choices));
    unsigned view_divisor = 1;
    for (const choice& c : p.parts) {
        const view_request& further = c.what->further_views;
        p.views += further.count;
        if (further.count_number >= 0)
            p.views += static_cast<unsigned>(c.numbers[further.count_number]);
        if (further.divisor >= 0)
            view_divisor = static_cast<unsigned>(c.numbers[further.divisor]);
        planning::add_settings(p, c);
    }
    p.resources.add({.name = "parameters", .kind = resource_kind::block});
    for (const choice& c : p.parts)
        planning::add_resources(p, c, view_divisor);
    for (const choice& c : p.parts)
        planning::add_steps(p, c, false, view_divisor);
    const std::size_t first = p.passes.size();
    planning::add_chain(p);
    planning::connect_chain(p, first);
    for (const choice& c : p.parts)
        planning::add_steps(p, c, true, view_divisor);
    planning::widen_stored(p);
    if (p.resources.cut || p.settings.cut || p.views > 1 + most_further_views)
        p.refused = {rules::few_resources, choices[2].what->name};
    if (p.passes.cut)
        p.refused = {rules::few_passes, choices[2].what->name};
    return p;
}

}
