// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/view_parameters.hpp>

namespace crease {

/// `far_depth` as a share of the distance of the far plane: a cleared texel must reach it in spite of
/// rounding.
inline constexpr double far_share = 0.999;

/// Which clip space a projection matrix maps to, and which row of the depth image comes first.
struct clip_space {
    bool depth_zero_to_one =
        true;          ///< NDC depth in [0, 1] (Vulkan, Direct3D), else in [-1, 1] and stored as z/2 + 1/2
    bool y_up = false; ///< NDC y = -1 is the last row of the image (Direct3D, or Vulkan with a negative
                       ///< viewport height); else it is row 0 (Vulkan, OpenGL)
};

/// Widens the projection of a picture by a guard band, to draw the larger depth image.
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
/// @param matrix  column-major, view space to clip space: perspective with [11] = -1 and [15] = 0,
/// orthographic
///                with [11] = 0 and [15] = 1
/// @param width,height  resolution of the picture in texels, > 0
/// @param guard   width of the guard band in texels, by which the depth image is larger than the picture on
/// each
///                side; `matrix` is the picture's, and `widen_projection` makes that of the depth image
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
