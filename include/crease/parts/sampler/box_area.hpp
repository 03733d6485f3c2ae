// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/areas.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file box_area_glsl{
    "sampler/box_area.glsl",
#include <crease/sampler/box_area.glsl>
};

struct box_area_part {
    using needs = traits<layers_of_areas>;
    static constexpr number takes[] = {
        {"size", 2, 4096, 40,
         "texels to a side, less one where odd: the listing's kernelDimension, 15 and 40"},
        {"past", 0, 1, 0,
         "whether a texel just past the far edge reads the last once more, as in the listing"}};
    static constexpr const glsl_file* files[] = {&area_tap_glsl, &box_area_glsl};
    static constexpr part description{
        .kind = role::sampler,
        .name = "box_area",
        .summary = "a square window around the receiver, as an area",
        .source = "unsharp-mask-ssao, listing",
        .files = files,
        .numbers = takes,
        .needs = needs::list,
        .offers = traits<area_taps, window_taps>::list,
    };
};

/// Sampler: the window of `box_window<Size>` as an area; what it costs does not depend on its size. With
/// `Past` it is that of the listing also at the far edges, where the area alone leaves out what the listing
/// reads twice.
template <int Size = 40, int Past = 0>
struct box_area : box_area_part {
    static constexpr int numbers[] = {Size, Past};
};

}
