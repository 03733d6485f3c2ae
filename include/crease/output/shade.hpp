// SPDX-License-Identifier: MIT
#pragma once

#include <crease/encoding.hpp>
#include <crease/output/occlusion_alone.hpp>

namespace crease {

inline constexpr glsl_file shade_result_glsl{
    "output/shade_result.glsl",
#include <crease/output/shade_result.glsl>
};

inline constexpr glsl_file shade_glsl{
    "output/shade.glsl",
#include <crease/output/shade.glsl>
};

inline constexpr glsl_file encoding_shade_glsl{
    "encoding/shade.glsl",
#include <crease/encoding/shade.glsl>
};

inline constexpr glsl_file encoding_shade_depth_glsl{
    "encoding/shade_depth.glsl",
#include <crease/encoding/shade_depth.glsl>
};

/// What leaves an effect to be subtracted from a colour.
inline constexpr encoding shade_encoding{"shade", format::r32_float, &encoding_shade_glsl};

/// What a filter reads: shade and linear depth.
inline constexpr encoding shade_depth_encoding{"shade_depth", format::rg32_uint, &encoding_shade_depth_glsl};

struct shade_part {
    static constexpr const glsl_file* gathered[] = {&occlusion_alone_glsl};
    static constexpr const encoding* images[] = {&visibility_encoding, &shade_encoding};
    static constexpr number takes[] = {
        {"highlight", 0, 1, 1, "1: the shade is negative where an estimator brightens; 0: never"}};
    static constexpr part description{
        .kind = role::output,
        .name = "shade",
        .summary = "visibility, and the shade that a host subtracts from a colour",
        .source = "unsharp-mask-ssao, listing",
        .glsl = &shade_glsl,
        .helpers = gathered,
        .numbers = takes,
        .offers = traits<any_order>::list,
        .result = &shade_result_glsl,
        .between = &shade_depth_encoding,
        .final_images = images,
    };
};

/// Output: visibility, and the image "shade": the strength times the occlusion, negative for a highlight.
/// With `Highlight` 0 the highlights along edges are clamped away, as in Luft et al. 2006.
template <int Highlight = 1>
struct shade : shade_part {
    static constexpr int numbers[] = {Highlight};
};

}
