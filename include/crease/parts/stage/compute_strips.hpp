// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/stage/compute.hpp>

#include <cstdint>

namespace crease {

/// `main` of the main pass, and where a texel is in the strips.
inline constexpr glsl_file compute_strips_glsl{
    "stage/compute_strips.glsl",
#include <crease/stage/compute_strips.glsl>
};

struct compute_strips_part {
    using needs = traits<layers_in_strips, one_resolution>;
    static constexpr number takes[] = {
        {"width", 1, 1024, 8, "of the workgroup, invocations"},
        {"height", 1, 1024, 8, "of the workgroup, invocations"},
        {"apron", 0, 1024, 24, "texels that are kept at each end of a row or column"},
    };
    static constexpr const glsl_file* files[] = {&compute_glsl};
    static constexpr const glsl_file* main_files[] = {&compute_strips_glsl};
    static constexpr part description{
        .kind = role::stage,
        .name = "compute_strips",
        .summary = "compute shaders that keep the rows and columns of a workgroup in shared memory",
        .source =
            "a-buffer-ssao 2013, V.B; Bavoil 2011, Horizon-Based Ambient Occlusion using Compute Shaders",
        .files = files,
        .main_files = main_files,
        .numbers = takes,
        .needs = needs::list,
    };
};

/// Stage: compute shaders with workgroups of `Width` x `Height`. That of the main pass first loads the texels
/// of its pixels, with `Apron` texels at each end of their rows and of their columns, into shared memory: of
/// a source of one layer its depth, of others the nearest four layers. Taps there read no image, as all of
/// `axes` do with a reach as wide; others do as elsewhere, and so the picture is that of `compute`, bit by
/// bit. What is kept must fit into 16384 bytes; where pixels are fewer than texels, it is more. Filters have
/// nothing in shared memory.
template <int Width = 8, int Height = 8, int Apron = 24>
struct compute_strips : compute_strips_part {
    static constexpr int numbers[] = {Width, Height, Apron};
};

/// Shared memory that every device has, in bytes.
inline constexpr std::int64_t most_shared_bytes = 16384;

/// Bytes of shared memory that a stage takes which needs layers_in_strips: four for each layer that is kept.
/// @param divisor  of the main pass
constexpr std::int64_t strip_bytes(const choice& stage, const choice& source, unsigned divisor) {
    const std::int64_t width = std::int64_t{stage.number_of("width")} * divisor,
                       height = std::int64_t{stage.number_of("height")} * divisor,
                       apron = stage.number_of("apron");
    const std::int64_t texels = (width + 2 * apron) * height + width * (height + 2 * apron);
    return texels * (has(source.what->offers, &layers_behind_front::value) ? 16 : 4);
}

}
