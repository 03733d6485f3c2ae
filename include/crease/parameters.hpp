// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace crease {

/// The camera of a depth image: what a texel and its depth mean in view space.
///
/// View space is right-handed, the camera looks down -Z, +Y is up. Depth is the positive distance along -Z.
/// Texel space has texel (i, j) of the picture at the centre (i + 0.5, j + 0.5), its origin where the image's
/// row 0 begins. The depth image may have a guard band: a border outside the picture, on all four sides.
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

    constexpr bool operator==(const view_parameters&) const = default;
};

/// The one uniform block of every effect: the C++ mirror of templates/crease/core/parameters.glsl (std140).
struct parameters {
    view_parameters view;        ///< of the picture
    view_parameters second_view; ///< of the second camera, where the effect has one
    float second_from_first[16] = {1, 0, 0, 0, 0, 1, 0, 0,
                                   0, 0, 1, 0, 0, 0, 0, 1}; ///< column-major, from the view space of the
                                                            ///< picture to that of the second camera
    float radius = 1;         ///< world-space AO radius R, view-space units, >= 0
    float bias = 0;           ///< see the estimator's settings
    float threshold = 0;      ///< see the estimator's settings
    float strength = 1;       ///< multiplies the occlusion (stochastic-depth-ao 8.1), >= 0
    float exponent = 1;       ///< applied to the visibility (stochastic-depth-ao 8.1), > 0
    float sharpness = 0;      ///< see the filter's settings
    std::uint32_t frame = 0;  ///< index that changes the per-pixel randomness
    float opacity = 1;        ///< see the settings of what samples the layers, in (0, 1]
    float front_reach = 0;    ///< see the fold's settings
    float falloff = 1;        ///< see the estimator's settings
    float unused[2] = {0, 0}; ///< pads to a multiple of 16 bytes

    constexpr bool operator==(const parameters&) const = default;
};

static_assert(offsetof(view_parameters, from_texel) == 0 && offsetof(view_parameters, depth_unpack) == 16 &&
              offsetof(view_parameters, far_depth) == 24 && offsetof(view_parameters, guard) == 28 &&
              offsetof(view_parameters, resolution) == 32 && offsetof(view_parameters, texel_size) == 40 &&
              sizeof(view_parameters) == 48);
static_assert(offsetof(parameters, view) == 0 && offsetof(parameters, second_view) == 48 &&
              offsetof(parameters, second_from_first) == 96 && offsetof(parameters, radius) == 160 &&
              offsetof(parameters, bias) == 164 && offsetof(parameters, threshold) == 168 &&
              offsetof(parameters, strength) == 172 && offsetof(parameters, exponent) == 176 &&
              offsetof(parameters, sharpness) == 180 && offsetof(parameters, frame) == 184 &&
              offsetof(parameters, opacity) == 188 && offsetof(parameters, front_reach) == 192 &&
              offsetof(parameters, falloff) == 196 && sizeof(parameters) == 208);

/// What `far_depth` is of the distance of the far plane: a cleared texel must reach it in spite of rounding.
inline constexpr double far_share = 0.999;

/// Which clip space a projection matrix maps to, and which row of the depth image comes first.
struct clip_space {
    bool depth_zero_to_one =
        true;          ///< NDC depth in [0, 1] (Vulkan, Direct3D), else in [-1, 1] and stored as z/2 + 1/2
    bool y_up = false; ///< NDC y = -1 is the last row of the image (Direct3D, or Vulkan with a negative
                       ///< viewport height); else it is row 0 (Vulkan, OpenGL)
};

/// Widens a projection by a guard band: from that of a picture to that which draws its larger depth image.
/// @param matrix  column-major, view space to clip space
/// @param width,height,guard  texels: of the picture, and the band on each of its sides
constexpr void widen_projection(float (&matrix)[16], unsigned width, unsigned height, unsigned guard) {
    const float across = static_cast<float>(width) / static_cast<float>(width + 2 * guard);
    const float down = static_cast<float>(height) / static_cast<float>(height + 2 * guard);
    for (int column = 0; column < 4; ++column) {
        matrix[4 * column] *= across;
        matrix[4 * column + 1] *= down;
    }
}

/// Fills a view from a projection matrix, perspective or orthographic, also off-centre, with
/// standard, reversed or infinite-far depth.
/// @param matrix column-major, view space to clip space; with [11] = -1 and [15] = 0 perspective, with [11] =
/// 0 and
///               [15] = 1 orthographic
/// @param width,height resolution of the picture in texels, > 0
/// @param guard  width of the guard band in texels: the depth image is larger than the picture by as much on
/// each
///               side, and was drawn with the field of view that this makes; `matrix` is that of the picture
/// @return false, with `v` unchanged, where the matrix is neither or is singular, or a size is 0
constexpr bool set_projection(view_parameters& v, const float (&matrix)[16], unsigned width, unsigned height,
                              clip_space clip = {}, unsigned guard = 0) {
    const bool perspective = matrix[11] == -1 && matrix[15] == 0;
    const bool orthographic = matrix[11] == 0 && matrix[15] == 1;
    if (!(perspective || orthographic) || matrix[0] == 0 || matrix[5] == 0 || width == 0 || height == 0)
        return false;
    // Device depth is ndc * a + b, so ndc = (z - b) / a.
    const double a = clip.depth_zero_to_one ? 1 : 0.5, b = clip.depth_zero_to_one ? 0 : 0.5;
    const double m10 = matrix[10], m14 = matrix[14];
    double scale, offset;
    if (perspective) { // ndc = -m10 + m14 / depth
        if (m14 == 0)
            return false;
        scale = 1 / (a * m14);
        offset = (m10 - b / a) / m14;
    } else { // ndc = -m10 * depth + m14
        if (m10 == 0)
            return false;
        scale = -1 / (a * m10);
        offset = (m14 + b / a) / m10;
    }
    // The far plane is the end of the device range with the greater depth; 1/depth <= 0 there means infinity.
    const double at_zero = static_cast<float>(offset),
                 at_one = static_cast<float>(scale) + static_cast<float>(offset);
    double far_depth = 1e15;
    if (perspective) {
        const double least = at_zero < at_one ? at_zero : at_one;
        if (least > 1e-15)
            far_depth = 1 / least;
    } else {
        far_depth = at_zero > at_one ? at_zero : at_one;
    }
    const double shift_x = perspective ? matrix[8] : -double(matrix[12]);
    const double shift_y = perspective ? matrix[9] : -double(matrix[13]);
    // ndc x = 2 * texel / width - 1, and view x = (ndc x + shift) / m0.
    const double flip = clip.y_up ? -1 : 1;
    v.from_texel[0] = static_cast<float>(2 / (width * double(matrix[0])));
    v.from_texel[1] = static_cast<float>(flip * 2 / (height * double(matrix[5])));
    v.from_texel[2] = static_cast<float>((shift_x - 1) / double(matrix[0]));
    v.from_texel[3] = static_cast<float>((shift_y - flip) / double(matrix[5]));
    v.depth_unpack[0] = static_cast<float>(scale);
    v.depth_unpack[1] = static_cast<float>(offset);
    v.far_depth = static_cast<float>(far_depth * far_share);
    v.resolution[0] = static_cast<float>(width);
    v.resolution[1] = static_cast<float>(height);
    v.guard = static_cast<float>(guard);
    v.texel_size[0] = 1 / static_cast<float>(width + 2 * guard);
    v.texel_size[1] = 1 / static_cast<float>(height + 2 * guard);
    return true;
}

}
