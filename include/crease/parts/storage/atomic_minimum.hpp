// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/storage/captures.hpp>

namespace crease {

inline constexpr glsl_file atomic_minimum_glsl{
    "storage/atomic_minimum.glsl",
#include <crease/storage/atomic_minimum.glsl>
};

inline constexpr glsl_file atomic_minimum_draw_glsl{
    "storage/atomic_minimum_draw.glsl",
#include <crease/storage/atomic_minimum_draw.glsl>
};

struct atomic_minimum_part {
    static constexpr resource layers[] = {{.name = "captured_layers",
                                           .texels = format::r32_uint,
                                           .life = lifetime::transient,
                                           .size = {.guarded = true},
                                           .arrayed = true,
                                           .further_names = further_captured_layers,
                                           .read = access::load,
                                           .cleared = true,
                                           .clear = ~0u,
                                           .shape = shape_layers}};
    static constexpr const glsl_file* drawing[] = {&atomic_minimum_draw_glsl};
    static constexpr step captures[] = {capture_layers(drawing, access::modify)};
    static constexpr const glsl_file* files[] = {&atomic_minimum_glsl};
    static constexpr part description{
        .kind = role::layer_storage,
        .name = "atomic_minimum",
        .summary = "an array image filled by atomic minimum: any number of samples, no multisampling",
        .source = "stochastic-depth-ao 2020, Algorithm 4",
        .files = files,
        .numbers = capture_places,
        .resources = layers,
        .steps = captures,
    };
};

/// Layer storage: an array image filled by atomic minimum, without multisampling. The numbers place its
/// bindings and constants among those of the host's geometry pass.
template <int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct atomic_minimum : atomic_minimum_part {
    static constexpr int numbers[] = {Set, FirstBinding, FirstConstant};
};

}
