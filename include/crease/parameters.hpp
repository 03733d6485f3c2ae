// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace crease {

/// The one uniform block of every effect: the C++ mirror of templates/crease/core/parameters.glsl (std140).
///
/// View space is right-handed, the camera looks down -Z, +Y is up. Depth is the positive distance along -Z.
/// Texel space has texel (i, j) at the centre (i + 0.5, j + 0.5), its origin where the image's row 0 begins.
struct parameters {
    float view_from_texel[4] = {1, 1, 0, 0}; ///< xy scale and zw offset: texel -> view-space xy at depth 1
                                             ///< (perspective) or at any depth (orthographic)
    float depth_unpack[2] = {
        0, 1}; ///< device depth z -> z * [0] + [1]: 1 / depth (perspective), depth (orthographic)
    float far_depth =
        1e15f;        ///< view-space units; a depth at or beyond it, or NaN, is background: visibility 1
    float radius = 1; ///< world-space AO radius R, view-space units, >= 0
    float resolution[2] = {1, 1}; ///< of the picture, in texels
    float texel_size[2] = {1, 1}; ///< 1 / the size of the depth image, which may be larger than the picture
    float bias = 0;               ///< see the estimator's settings
    float threshold = 0;          ///< see the estimator's settings
    float strength = 1;           ///< multiplies the occlusion (stochastic-depth-ao 8.1), >= 0
    float exponent = 1;           ///< applied to the visibility (stochastic-depth-ao 8.1), > 0
    float sharpness = 0;          ///< see the filter's settings
    std::uint32_t frame = 0;      ///< index that changes the per-pixel randomness
    float unused[2] = {0, 0};     ///< pads to a multiple of 16 bytes

    constexpr bool operator==(const parameters&) const = default;
};

static_assert(offsetof(parameters, view_from_texel) == 0 && offsetof(parameters, depth_unpack) == 16 &&
              offsetof(parameters, far_depth) == 24 && offsetof(parameters, radius) == 28 &&
              offsetof(parameters, resolution) == 32 && offsetof(parameters, texel_size) == 40 &&
              offsetof(parameters, bias) == 48 && offsetof(parameters, threshold) == 52 &&
              offsetof(parameters, strength) == 56 && offsetof(parameters, exponent) == 60 &&
              offsetof(parameters, sharpness) == 64 && offsetof(parameters, frame) == 68 &&
              sizeof(parameters) == 80);

/// Which clip space a projection matrix maps to, and which row of the depth image comes first.
struct clip_space {
    bool depth_zero_to_one =
        true;          ///< NDC depth in [0, 1] (Vulkan, Direct3D), else in [-1, 1] and stored as z/2 + 1/2
    bool y_up = false; ///< NDC y = -1 is the last row of the image (Direct3D, or Vulkan with a negative
                       ///< viewport height); else it is row 0 (Vulkan, OpenGL)
};

/// Fills the view of `p` from a projection matrix, perspective or orthographic, also off-centre, with
/// standard, reversed or infinite-far depth.
/// @param matrix column-major, view space to clip space; with [11] = -1 and [15] = 0 perspective, with [11] =
/// 0 and
///               [15] = 1 orthographic
/// @param width,height resolution of the picture in texels, > 0
/// @return false, with `p` unchanged, where the matrix is neither or is singular, or a size is 0
constexpr bool set_projection(parameters& p, const float (&matrix)[16], unsigned width, unsigned height,
                              clip_space clip = {}) {
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
    p.view_from_texel[0] = static_cast<float>(2 / (width * double(matrix[0])));
    p.view_from_texel[1] = static_cast<float>(flip * 2 / (height * double(matrix[5])));
    p.view_from_texel[2] = static_cast<float>((shift_x - 1) / double(matrix[0]));
    p.view_from_texel[3] = static_cast<float>((shift_y - flip) / double(matrix[5]));
    p.depth_unpack[0] = static_cast<float>(scale);
    p.depth_unpack[1] = static_cast<float>(offset);
    p.far_depth = static_cast<float>(far_depth * 0.999); // a cleared texel must reach it in spite of rounding
    p.resolution[0] = static_cast<float>(width);
    p.resolution[1] = static_cast<float>(height);
    p.texel_size[0] = 1 / static_cast<float>(width);
    p.texel_size[1] = 1 / static_cast<float>(height);
    return true;
}

}
