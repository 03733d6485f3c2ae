// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/storage/multisampled.hpp>

namespace crease {

inline constexpr glsl_file centred_samples_draw_glsl{
    "storage/centred_samples_draw.glsl",
#include <crease/storage/centred_samples_draw.glsl>
};

struct centred_samples_part {
    static constexpr resource layers[] = {multisampled_layers(true)};
    static constexpr const glsl_file* drawing[] = {&centred_samples_draw_glsl, &sample_mask_glsl};
    static constexpr step captures[] = {capture_layers(drawing, access::attachment)};
    static constexpr const glsl_file* files[] = {&multisampled_glsl};
    static constexpr part description{
        .kind = role::layer_storage,
        .name = "centred_samples",
        .summary = "the samples of a multisampled depth image that all lie at the centre of the texel",
        .source = "stochastic-depth-ao 2020, 5.1 and 6.1",
        .files = files,
        .numbers = capture_places,
        .resources = layers,
        .steps = captures,
    };
};

/// Layer storage: the samples of a multisampled depth image, which the host places at the centre of the
/// texel, in Vulkan by VK_EXT_sample_locations. The numbers place its bindings and constants among those of
/// the host's geometry pass.
template <int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct centred_samples : centred_samples_part {
    static constexpr int numbers[] = {Set, FirstBinding, FirstConstant};
};

}
