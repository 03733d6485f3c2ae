// SPDX-License-Identifier: MIT
#pragma once

#include <crease/contract.hpp>

#include <crease/core/files.hpp>

namespace crease {

/// The most passes, resources and captures that an effect may have.
inline constexpr std::size_t most_passes = 32, most_resources = 48, most_captures = 2;

/// The most images that one pass may write.
inline constexpr std::size_t most_outputs = 4;

/// A pass before its text: which step of which part, and between which resources.
struct planned_pass {
    const step* what = nullptr;
    const glsl_file* body = nullptr; ///< the step's, or what takes its place
    choice owner{};                  ///< the part whose step it is; of the main pass the estimator
    int input = -1;                  ///< resource that a filter reads; -1: none
    fixed_list<unsigned, most_outputs> outputs{};
    bool last = false; ///< whether the outputs are the effect's
    extent size{};     ///< of the outputs
    unsigned input_divisor = 1;
    int view = 0; ///< index of the camera that it works for; -1: of both
};

/// A capture before its text.
struct planned_capture {
    const capture_step* what = nullptr;
    choice owner{};
    unsigned output = 0; ///< the resource that it fills
    int view = 0;
};

/// An effect before its text.
struct plan {
    choice_list choices;
    // By role one more than the index of its first choice: a compiler takes longer to look for it each time.
    unsigned char place_of[role_count]{};
    fixed_list<planned_capture, most_captures> captures;
    fixed_list<planned_pass, most_passes> passes;
    fixed_list<resource, most_resources> resources;

    /// The first choice of a role; null where there is none.
    constexpr const choice* find(role r) const {
        const unsigned place = place_of[static_cast<unsigned>(r)];
        return place == 0 ? nullptr : &choices.items[place - 1];
    }
    /// The choice of a role that every effect has.
    constexpr const choice& chosen(role r) const { return *find(r); }

    constexpr unsigned index_of(std::string_view resource_name) const {
        unsigned i = 0;
        while (resources[i].name != resource_name)
            ++i;
        return i;
    }
    /// The resource that a camera's pass finds under a name: of what a geometry pass captures each has its
    /// own.
    constexpr unsigned index_of(std::string_view resource_name, int view) const {
        const unsigned i = index_of(resource_name);
        return view == 1 && resources[i].life == lifetime::captured
                   ? index_of(find(role::second_view)->what->intermediates[0].name)
                   : i;
    }
    constexpr bool has_resource(std::string_view resource_name) const {
        for (const resource& r : resources)
            if (r.name == resource_name)
                return true;
        return false;
    }
};

/// The roles whose functions the main pass calls, in the order of their text.
inline constexpr role main_roles[] = {
    role::second_view, role::projection, role::depth_encoding, role::depth_source, role::normals,
    role::noise,       role::sampler,    role::estimator,      role::fold,         role::output};

inline constexpr step main_step{
    .name = "visibility", .body = &visibility_glsl, .includes = main_roles, .columns = 16};

namespace planning {

// Images between passes need names with static storage.
inline constexpr std::string_view intermediate[] = {"between_0",  "between_1",  "between_2",  "between_3",
                                                    "between_4",  "between_5",  "between_6",  "between_7",
                                                    "between_8",  "between_9",  "between_10", "between_11",
                                                    "between_12", "between_13", "between_14", "between_15"};

constexpr unsigned count_of(const counted& by, const choice& source) {
    return (static_cast<unsigned>(source.numbers[by.number]) + static_cast<unsigned>(by.share) - 1) /
           static_cast<unsigned>(by.share);
}

/// The least number of samples, a power of 2, that a multisampled image may have for `count`.
constexpr unsigned samples_for(unsigned count) {
    unsigned samples = 2;
    while (samples < count)
        samples *= 2;
    return samples;
}

/// Adds a resource as the depth source's numbers make it, once for all that name it.
constexpr void add_resource(plan& p, const resource& wanted) {
    if (p.has_resource(wanted.name))
        return;
    p.resources.add(wanted);
    resource& r = p.resources[p.resources.size() - 1];
    const choice& source = p.chosen(role::depth_source);
    if (r.layers_by.number >= 0) // a second camera's layers come after those of the first
        r.layers = count_of(r.layers_by, source) *
                   (r.life == lifetime::transient && p.find(role::second_view) ? 2 : 1);
    if (!r.texels_of_few.empty()) {
        const auto layers = static_cast<std::size_t>(source.numbers[r.layers_by.number]);
        if (layers <= r.texels_of_few.size())
            r.texels = r.texels_of_few[layers - 1];
    }
    if (r.texels_by)
        for (const choice& c : p.choices)
            for (const extra& e : c.what->extras)
                if (e.on_need == r.texels_by && e.texels != format::none)
                    r.texels = e.texels;
    if (r.samples_by.number >= 0)
        r.samples = samples_for(count_of(r.samples_by, source));
    if (r.divisor_by >= 0)
        r.size.divisor = static_cast<unsigned>(source.numbers[r.divisor_by]);
    if (r.fill)
        r.count = static_cast<unsigned>(source.numbers[0]);
    r.layers_by = r.samples_by = {};
    r.divisor_by = -1;
    r.texels_of_few = {};
    r.texels_by = nullptr;
}

constexpr void add_resources(plan& p, array_view<const resource> wanted) {
    for (const resource& r : wanted)
        add_resource(p, r);
}

constexpr void add_inputs(plan& p, array_view<const role> includes) {
    for (role r : includes)
        if (const choice* c = p.find(r))
            add_resources(p, c->what->resources);
}

/// What the geometry pass fills for one camera; of the second its own image, whose name `second` and size
/// differ.
constexpr void add_capture(plan& p, const choice& carrier, int view, std::string_view name,
                           unsigned divisor) {
    const capture_step& s = *carrier.what->captures;
    for (const resource& r : carrier.what->resources)
        if (r.name == s.writes) {
            resource own = r;
            own.name = name;
            if (view != 0)
                own.size = {.divisor = divisor};
            add_resource(p, own);
        }
    p.captures.add({.what = &s, .owner = carrier, .output = p.index_of(name), .view = view});
}

/// The steps of the depth encoding or the depth source, which fill what later passes read of it.
constexpr void add_builds(plan& p, const choice& owner, int view, unsigned divisor) {
    for (const step& s : owner.what->steps) {
        if (owner.numbers[0] < s.from)
            continue;
        planned_pass pass{.what = &s, .body = s.body, .owner = owner, .view = view};
        for (std::string_view name : s.writes)
            pass.outputs.add(p.index_of(name));
        pass.size = p.resources[pass.outputs[0]].size;
        if (view != 0)
            pass.size = {.divisor = divisor};
        p.passes.add(pass);
    }
}

/// The chain of steps that hand a visibility on: the main pass, and then those of the filters.
constexpr void add_chain(plan& p) {
    unsigned divisor = 1;
    for (const choice& c : p.choices)
        divisor *= rules::upsampling_of(c);
    const choice* second = p.find(role::second_view);
    p.passes.add({.what = &main_step,
                  .body = second ? second->what->main_body : main_step.body,
                  .owner = p.chosen(role::estimator),
                  .size = {.divisor = divisor},
                  .input_divisor = divisor,
                  .view = second ? -1 : 0});
    for (const choice& c : p.choices)
        if (c.what->kind == role::filter)
            for (const step& s : c.what->steps) {
                const unsigned input_divisor = divisor;
                if (&s == &c.what->steps.back())
                    divisor /= rules::upsampling_of(c);
                p.passes.add({.what = &s,
                              .body = s.body,
                              .owner = c,
                              .size = {.divisor = divisor},
                              .input_divisor = input_divisor});
            }
}

/// Gives each step of the chain from `first` on what it writes: of the last the images that leave the effect.
constexpr void connect_chain(plan& p, std::size_t first) {
    const part& output = *p.chosen(role::output).what;
    for (std::size_t i = first; i < p.passes.size(); ++i) {
        planned_pass& pass = p.passes[i];
        pass.last = i + 1 == p.passes.size();
        const auto add = [&](std::string_view name, format texels, lifetime life) {
            pass.outputs.add(static_cast<unsigned>(p.resources.size()));
            p.resources.add(
                {.name = name, .texels = texels, .life = life, .size = pass.size, .read = access::load});
        };
        if (pass.last) {
            for (const encoding* image : output.final_images)
                add(image->name, image->texels, lifetime::output);
        } else {
            add(intermediate[i - first], output.between->texels, lifetime::transient);
            p.passes[i + 1].input = static_cast<int>(pass.outputs[0]);
        }
    }
}

}

/// Plans the effect of parts that `check` accepts.
constexpr plan make_plan(array_view<const choice> choices) {
    plan p{.choices = complete(choices), .captures = {}, .passes = {}, .resources = {}};
    for (std::size_t i = p.choices.size(); i-- > 0;)
        p.place_of[static_cast<unsigned>(p.choices[i].what->kind)] = static_cast<unsigned char>(i + 1);
    p.resources.add({.name = "parameters"});
    const choice& source = p.chosen(role::depth_source);
    const choice* second = p.find(role::second_view);
    const choice* carrier = p.find(role::layer_carrier);
    const unsigned second_divisor = second ? static_cast<unsigned>(second->numbers[0]) : 1;
    if (carrier) {
        planning::add_inputs(p, carrier->what->captures->includes);
        planning::add_capture(p, *carrier, 0, carrier->what->captures->writes, 1);
        if (second)
            planning::add_capture(p, *carrier, 1, second->what->intermediates[0].name, second_divisor);
    }
    planning::add_inputs(p, main_roles);
    const choice& depth = p.chosen(role::depth_encoding);
    for (const choice* owner : {&depth, &source}) {
        planning::add_resources(p, owner->what->intermediates);
        for (const step& s : owner->what->steps)
            planning::add_inputs(p, s.includes);
        planning::add_builds(p, *owner, 0, 1);
    }
    if (second)
        planning::add_builds(p, source, 1, second_divisor);
    const std::size_t first = p.passes.size();
    planning::add_chain(p);
    for (std::size_t i = first + 1; i < p.passes.size(); ++i)
        planning::add_inputs(p, p.passes[i].what->includes);
    planning::connect_chain(p, first);
    return p;
}

}
