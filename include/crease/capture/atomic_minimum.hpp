// SPDX-License-Identifier: MIT
#pragma once

#include <crease/capture/places.hpp>

namespace crease {

inline constexpr glsl_file atomic_minimum_glsl{
    "capture/atomic_minimum.glsl",
#include <crease/capture/atomic_minimum.glsl>
};

inline constexpr glsl_file atomic_minimum_draw_glsl{
    "capture/atomic_minimum_draw.glsl",
#include <crease/capture/atomic_minimum_draw.glsl>
};

struct atomic_minimum_part {
    static constexpr resource layers[] = {{.name = "captured_layers",
                                           .texels = format::r32_uint,
                                           .life = lifetime::captured,
                                           .size = {.guarded = true},
                                           .arrayed = true,
                                           .read = access::load,
                                           .clear = ~0u,
                                           .layers_by = {.number = 0}}};
    static constexpr role drawing[] = {role::projection, role::layer_sampling};
    static constexpr capture_step draws{.name = "layers",
                                        .body = &atomic_minimum_draw_glsl,
                                        .includes = drawing,
                                        .writes = "captured_layers",
                                        .how = access::modify};
    static constexpr part description{
        .kind = role::layer_carrier,
        .name = "atomic_minimum",
        .summary = "an array image filled by atomic minimum: any number of samples, no multisampling",
        .source = "stochastic-depth-ao 2020, Algorithm 4",
        .glsl = &atomic_minimum_glsl,
        .numbers = capture_places,
        .resources = layers,
        .captures = &draws,
    };
};

/// Layer carrier: an array image filled by atomic minimum, without multisampling. The numbers place its
/// bindings and constants among those of the host's geometry pass.
template <int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct atomic_minimum : atomic_minimum_part {
    static constexpr int numbers[] = {Set, FirstBinding, FirstConstant};
};

}
