// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/output/outputs.hpp>

namespace crease {

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
inline constexpr resource shade_image{
    .name = "shade", .texels = format::r32_float, .life = lifetime::output, .read = access::load};

struct shade_part {
    static constexpr const glsl_file* files[] = {&encoding_visibility_glsl, &encoding_shade_glsl,
                                                 &encoding_shade_depth_glsl, &shade_glsl};
    static constexpr resource images[] = {between_image(format::rg32_uint), visibility_image, shade_image};
    static constexpr number takes[] = {
        {"highlight", 0, 1, 1, "1: the shade is negative where an estimator brightens; 0: never"}};
    static constexpr part description{
        .kind = role::output,
        .name = "shade",
        .summary = "visibility, and the shade that a host subtracts from a colour",
        .source = "unsharp-mask-ssao, listing",
        .files = files,
        .numbers = takes,
        .resources = images,
        .offers = traits<handed_on_normals, any_resolution>::list,
    };
};

/// Output: visibility, and the image "shade": the strength times the occlusion, negative for a highlight.
/// With `Highlight` 0 the highlights along edges are clamped away, as in Luft et al. 2006.
template <int Highlight = 1>
struct shade : shade_part {
    static constexpr int numbers[] = {Highlight};
};

}
