// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/storage/captures.hpp>

namespace crease {

inline constexpr glsl_file multisampled_glsl{
    "storage/multisampled.glsl",
#include <crease/storage/multisampled.glsl>
};

inline constexpr glsl_file sample_mask_glsl{
    "storage/sample_mask.glsl",
#include <crease/storage/sample_mask.glsl>
};

inline constexpr glsl_file multisampled_draw_glsl{
    "storage/multisampled_draw.glsl",
#include <crease/storage/multisampled_draw.glsl>
};

/// The multisampled depth image that keeps the layers.
constexpr resource multisampled_layers(bool centred) {
    return {.name = "captured_layers",
            .texels = format::d32_float,
            .life = lifetime::transient,
            .size = {.guarded = true},
            .centred = centred,
            .further_names = further_captured_layers,
            .shape = shape_samples};
}

struct multisampled_part {
    static constexpr resource layers[] = {multisampled_layers(false)};
    static constexpr const glsl_file* drawing[] = {&multisampled_draw_glsl, &sample_mask_glsl};
    static constexpr step captures[] = {capture_layers(drawing, access::attachment)};
    static constexpr const glsl_file* files[] = {&multisampled_glsl};
    static constexpr part description{
        .kind = role::layer_storage,
        .name = "multisampled",
        .summary = "the samples of a multisampled depth image",
        .source = "stochastic-depth-ao 2020, 5.1 and 6.1",
        .files = files,
        .numbers = capture_places,
        .resources = layers,
        .steps = captures,
    };
};

/// Layer storage: the samples of a multisampled depth image, wherever they lie. The default. The numbers
/// place its bindings and constants among those of the host's geometry pass.
template <int Set = 0, int FirstBinding = 0, int FirstConstant = 0>
struct multisampled : multisampled_part {
    static constexpr int numbers[] = {Set, FirstBinding, FirstConstant};
};

}
