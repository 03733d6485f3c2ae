// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/program.hpp>
#include <crease/effect/effect_view.hpp>
#include <crease/parts/depth/layers.hpp>

namespace crease {

inline constexpr piece fullscreen_vulkan[] = {
    {"interface", "#version 450\n#define CREASE_VERTEX_INDEX gl_VertexIndex\n"},
    {fullscreen_glsl.name, fullscreen_glsl.text, fullscreen_glsl.first_line}};
inline constexpr piece fullscreen_opengl[] = {
    {"interface", "#version 430\n#define CREASE_VERTEX_INDEX gl_VertexID\n"},
    {fullscreen_glsl.name, fullscreen_glsl.text, fullscreen_glsl.first_line}};

inline constexpr piece fullscreen_glsl_es_300[] = {
    {"interface", "#version 300 es\n#define CREASE_VERTEX_INDEX gl_VertexID\n"},
    {fullscreen_glsl.name, fullscreen_glsl.text, fullscreen_glsl.first_line}};
inline constexpr piece fullscreen_glsl_es_310[] = {
    {"interface", "#version 310 es\n#define CREASE_VERTEX_INDEX gl_VertexID\n"},
    {fullscreen_glsl.name, fullscreen_glsl.text, fullscreen_glsl.first_line}};

/// The vertex shader of the fragment passes of a plan.
constexpr array_view<const piece> fullscreen_of(const plan& p) {
    if (p.is_glsl_es_300())
        return fullscreen_glsl_es_300;
    const dialect_kind dialect = p.dialect();
    return dialect == dialect_kind::glsl_es  ? array_view<const piece>(fullscreen_glsl_es_310)
           : dialect == dialect_kind::opengl ? array_view<const piece>(fullscreen_opengl)
                                             : array_view<const piece>(fullscreen_vulkan);
}

/// The pass without its lists.
constexpr pass describe(const plan& p, const planned_pass& planned) {
    const bool further = planned.view > 0 && planned.stage == stage_kind::geometry;
    pass described{.name = further ? p.resources[planned.outputs[0]].name : planned.what->name,
                   .stage = planned.stage,
                   .dialect = p.dialect(),
                   .pieces = {},
                   .vertex_pieces = {},
                   .bindings = {},
                   .constants = {},
                   .size = planned.size,
                   .covers = planned.what->kind == step_kind::rows      ? dispatch::rows
                             : planned.what->kind == step_kind::columns ? dispatch::columns
                                                                        : dispatch::texels,
                   .view = planned.view,
                   .takes_surfaces =
                       planned.stage == stage_kind::geometry && p.needs(&layers_with_opacity::value)};
    if (planned.stage == stage_kind::fragment)
        described.vertex_pieces = fullscreen_of(p);
    return described;
}

/// A definition of a program as a piece of its text.
constexpr piece piece_of(const linker::linked& what) {
    const definition& own = what.from->definitions.items[what.index];
    const glsl_file& file = *what.from->file;
    return {file.name,
            {file.text.data() + own.begin, static_cast<std::size_t>(own.end - own.begin)},
            file.first_line + own.line};
}

/// How many pieces a program has: one for its interface and each definition, and two more around what the
/// last begins with.
constexpr std::size_t piece_count(const program& written) {
    return 1 + written.definitions.size() + (written.sets_view ? 2 : 0);
}

/// Lists the pieces of a program.
/// @param head  the characters of its interface
/// @param to    of `piece_count` pieces
constexpr void list_pieces(const program& written, const char* head, piece* to) {
    *to++ = {"interface", {head, written.head.size()}};
    for (const linker::linked& each : written.definitions)
        *to++ = piece_of(each);
    if (!written.sets_view)
        return;
    const piece last = to[-1];
    const std::size_t body = last.text.find("{\n") + 2;
    unsigned line = last.first_line;
    for (const char c : last.text.substr(0, body))
        line += c == '\n' ? 1 : 0;
    to[-1].text = last.text.substr(0, body);
    to[0] = {"interface", "    crease_view = crease_view_of(crease_view_index);\n"};
    to[1] = {last.name, last.text.substr(body), line};
}

/// Which resources of a plan an effect has: the block of parameters, what its passes touch, and the outputs.
struct resource_map {
    bool is_used[most_resources]{};
    unsigned index[most_resources]{}; ///< in the effect
    unsigned count = 0;

    constexpr void use(const program& written) {
        for (const binding& b : written.bindings)
            is_used[b.resource] = true;
    }
    constexpr void number(const plan& p) {
        is_used[0] = true;
        for (std::size_t i = 0; i < p.resources.size(); ++i) {
            index[i] = count;
            count += is_used[i] ? 1 : 0;
        }
    }
};

/// Why the passes of a plan do not fit each other; `next` checks them in their order.
struct pass_order {
    bool is_filled[most_resources]{};

    constexpr refusal next(const plan& p, const planned_pass& pass, const program& written) {
        for (const binding& b : written.bindings) {
            const resource& r = p.resources[b.resource];
            if (!writes(b.how) && r.life == lifetime::transient && !r.cleared && !is_filled[b.resource])
                return {rules::written_first, pass.what->name, r.name};
        }
        for (const binding& b : written.bindings)
            if (writes(b.how))
                is_filled[b.resource] = true;
        if (written.bindings.cut || written.constants.cut)
            return {rules::few_passes, pass.what->name};
        return written.cut ? refusal{rules::short_programs, pass.what->name} : refusal{};
    }
};

/// A resource of a plan as one of the effect, in which each camera's stands for itself.
constexpr resource describe(resource planned) {
    planned.further_names = {};
    return planned;
}

/// What the passes of a plan require of a device.
constexpr device_features required_features(const plan& p) {
    device_features required;
    for (const choice& c : p.parts)
        required |= c.what->features;
    for (const planned_pass& pass : p.passes)
        for (unsigned output : pass.outputs) {
            const resource& filled = p.resources[output];
            if (pass.stage == stage_kind::geometry) {
                required.fragment_stores_and_atomics |= p.is_vulkan() && pass.what->how == access::modify;
                if (pass.what->how == access::attachment)
                    required.depth_samples |= filled.samples;
                if (filled.centred)
                    required.centred_depth_samples |= filled.samples;
            } else if (p.is_vulkan() && pass.stage == stage_kind::compute) {
                required.extended_storage_formats |= facts_of(filled.texels).extended;
            }
        }
    return required;
}

}
