// SPDX-License-Identifier: MIT
#pragma once

#include <crease/capture/places.hpp>

namespace crease {

inline constexpr glsl_file multisampled_glsl{
    "capture/multisampled.glsl",
#include <crease/capture/multisampled.glsl>
};

inline constexpr glsl_file sample_mask_glsl{
    "capture/sample_mask.glsl",
#include <crease/capture/sample_mask.glsl>
};

inline constexpr glsl_file multisampled_draw_glsl{
    "capture/multisampled_draw.glsl",
#include <crease/capture/multisampled_draw.glsl>
};

struct multisampled_part {
    static constexpr resource layers[] = {{.name = "captured_layers",
                                           .texels = format::d32_float,
                                           .life = lifetime::captured,
                                           .size = {.guarded = true},
                                           .samples_by = {.number = 0}}};
    static constexpr role drawing[] = {role::projection, role::layer_sampling};
    static constexpr const glsl_file* masking[] = {&sample_mask_glsl};
    static constexpr capture_step draws{.name = "layers",
                                        .body = &multisampled_draw_glsl,
                                        .includes = drawing,
                                        .helpers = masking,
                                        .writes = "captured_layers",
                                        .how = access::attachment};
    static constexpr part description{
        .kind = role::layer_carrier,
        .name = "multisampled",
        .summary = "the samples of a multisampled depth image",
        .source = "stochastic-depth-ao 2020, 5.1 and 6.1",
        .glsl = &multisampled_glsl,
        .numbers = capture_places,
        .resources = layers,
        .captures = &draws,
    };
};

/// Layer carrier: the samples of a multisampled depth image, wherever they lie. The default. The numbers
/// place its bindings and constants among those of the host's geometry pass.
template <int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct multisampled : multisampled_part {
    static constexpr int numbers[] = {Set, FirstBinding, FirstConstant};
};

}
