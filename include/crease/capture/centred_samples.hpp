// SPDX-License-Identifier: MIT
#pragma once

#include <crease/capture/multisampled.hpp>

namespace crease {

inline constexpr glsl_file centred_samples_draw_glsl{
    "capture/centred_samples_draw.glsl",
#include <crease/capture/centred_samples_draw.glsl>
};

struct centred_samples_part {
    static constexpr const glsl_file* reading[] = {&multisampled_glsl};
    static constexpr resource layers[] = {{.name = "captured_layers",
                                           .texels = format::d32_float,
                                           .life = lifetime::captured,
                                           .size = {.guarded = true},
                                           .centred = true,
                                           .samples_by = {.number = 0}}};
    static constexpr capture_step draws{.name = "layers",
                                        .body = &centred_samples_draw_glsl,
                                        .includes = multisampled_part::drawing,
                                        .helpers = multisampled_part::masking,
                                        .writes = "captured_layers",
                                        .how = access::attachment};
    static constexpr part description{
        .kind = role::layer_carrier,
        .name = "centred_samples",
        .summary = "the samples of a multisampled depth image that all lie at the centre of the texel",
        .source = "stochastic-depth-ao 2020, 5.1 and 6.1",
        .helpers = reading,
        .numbers = capture_places,
        .resources = layers,
        .captures = &draws,
    };
};

/// Layer carrier: the samples of a multisampled depth image, which the host places at the centre of the
/// texel, in Vulkan by VK_EXT_sample_locations. The numbers place its bindings and constants among those of
/// the host's geometry pass.
template <int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct centred_samples : centred_samples_part {
    static constexpr int numbers[] = {Set, FirstBinding, FirstConstant};
};

}
