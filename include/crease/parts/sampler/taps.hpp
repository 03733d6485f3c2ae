// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// Taps on the screen, each at the centre of a texel.
CREASE_TRAIT(screen_taps, sampler, "taps on the screen are needed, which the sampler does not propose");

/// Screen taps in order of distance along directions.
CREASE_TRAIT(ordered_taps, sampler,
             "the estimator needs taps in order along directions, which the sampler does not propose");

/// Taps in order along the half slices of directions, of which the sampler tells how they are weighed:
/// crease_slice_weight.
CREASE_TRAIT(slice_taps, sampler,
             "the estimator needs taps in order along half slices, which the sampler does not propose");

/// Taps each of which may look at a texel near its own instead.
CREASE_TRAIT(movable_taps, sampler,
             "the depth source moves taps to texels near their own, which taps of the sampler do not allow");

/// Taps at points of view space that fill a sphere or a hemisphere around the receiver.
CREASE_TRAIT(point_taps, sampler,
             "the estimator needs taps at points in space, which the sampler does not propose");

/// Taps along the rays of texels, each the chord of a sphere or a hemisphere around the receiver.
CREASE_TRAIT(line_taps, sampler,
             "the estimator needs taps along lines through a volume, which the sampler does not propose");

/// Taps that together cover each texel of a window around the receiver's.
CREASE_TRAIT(window_taps, sampler,
             "the estimator needs taps at each texel of a window, which the sampler does not propose");

/// Taps each of which covers an area of the picture.
CREASE_TRAIT(area_taps, sampler,
             "the depth source holds means over areas, and the sampler proposes single texels");

/// A tap of the area that the sample box of the AO radius covers.
CREASE_TRAIT(sample_area_taps, sampler,
             "the estimator needs the area of the sample box, which the sampler does not propose");

/// The area that the sample box around a receiver covers.
inline constexpr glsl_file sample_area_glsl{
    "sampler/sample_area.glsl",
#include <crease/sampler/sample_area.glsl>
};

inline constexpr glsl_file area_tap_glsl{
    "sampler/area_tap.glsl",
#include <crease/sampler/area_tap.glsl>
};

inline constexpr glsl_file screen_tap_glsl{
    "sampler/screen_tap.glsl",
#include <crease/sampler/screen_tap.glsl>
};

inline constexpr glsl_file slice_tap_glsl{
    "sampler/slice_tap.glsl",
#include <crease/sampler/slice_tap.glsl>
};

inline constexpr glsl_file stepped_tap_glsl{
    "sampler/stepped_tap.glsl",
#include <crease/sampler/stepped_tap.glsl>
};

inline constexpr glsl_file share_inside_glsl{
    "sampler/share_inside.glsl",
#include <crease/sampler/share_inside.glsl>
};

inline constexpr glsl_file radius_inside_glsl{
    "sampler/radius_inside.glsl",
#include <crease/sampler/radius_inside.glsl>
};

inline constexpr glsl_file point_tap_glsl{
    "sampler/point_tap.glsl",
#include <crease/sampler/point_tap.glsl>
};

inline constexpr glsl_file line_tap_glsl{
    "sampler/line_tap.glsl",
#include <crease/sampler/line_tap.glsl>
};

inline constexpr glsl_file texel_ray_glsl{
    "sampler/texel_ray.glsl",
#include <crease/sampler/texel_ray.glsl>
};

inline constexpr glsl_file disk_spiral_glsl{
    "sampler/disk_spiral.glsl",
#include <crease/sampler/disk_spiral.glsl>
};

inline constexpr glsl_file disk_lines_glsl{
    "sampler/disk_lines.glsl",
#include <crease/sampler/disk_lines.glsl>
};

}
