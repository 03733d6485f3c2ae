// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace crease {

/// The camera of a depth image: what a texel and its depth mean in view space.
///
/// View space is right-handed, the camera looks down -Z, +Y is up. Depth is the positive distance along -Z.
/// Texel space has the centre of the picture's texel (i, j) at (i + 0.5, j + 0.5), and its origin where row 0
/// of the picture begins. The depth image may have a guard band: a border outside the picture, on all four
/// sides.
struct view_parameters {
    float from_texel[4] = {1, 1, 0, 0}; ///< xy scale and zw offset: texel -> view-space xy at depth 1
                                        ///< (perspective) or at any depth (orthographic)
    float depth_unpack[2] = {
        0, 1}; ///< device depth z -> z * [0] + [1]: 1 / depth (perspective), depth (orthographic)
    float far_depth =
        1e15f;       ///< view-space units; a depth at or beyond it, or NaN, is background: visibility 1
    float guard = 0; ///< width of the guard band, texels (stochastic-depth-ao 7.2, case 1)
    float resolution[2] = {1, 1}; ///< of the picture, in texels
    float texel_size[2] = {1, 1}; ///< 1 / the size of the depth image, guard band included

    /// Member by member.
    constexpr bool operator==(const view_parameters&) const = default;
};

static_assert(offsetof(view_parameters, from_texel) == 0 && offsetof(view_parameters, depth_unpack) == 16 &&
              offsetof(view_parameters, far_depth) == 24 && offsetof(view_parameters, guard) == 28 &&
              offsetof(view_parameters, resolution) == 32 && offsetof(view_parameters, texel_size) == 40 &&
              sizeof(view_parameters) == 48);

}
