// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/sampler/taps.hpp>

namespace crease {

inline constexpr glsl_file box_window_glsl{
    "sampler/box_window.glsl",
#include <crease/sampler/box_window.glsl>
};

struct box_window_part {
    using needs = traits<depth_layers>;
    static constexpr number takes[] = {
        {"size", 2, 256, 15,
         "texels to a side, less one where odd: the listing's kernelDimension, 15 and 40"}};
    static constexpr const glsl_file* files[] = {&screen_tap_glsl, &box_window_glsl};
    static constexpr part description{
        .kind = role::sampler,
        .name = "box_window",
        .summary = "each texel of a square window around the receiver",
        .source = "unsharp-mask-ssao, listing",
        .files = files,
        .numbers = takes,
        .needs = needs::list,
        .offers = traits<window_taps>::list,
    };
};

/// Sampler: a window of `Size` x `Size` texels, from floor(`Size` / 2) before the receiver up to as many
/// after it, that one left out.
template <int Size = 15>
struct box_window : box_window_part {
    static constexpr int numbers[] = {Size};
};

}
