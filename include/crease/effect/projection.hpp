// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/view_parameters.hpp>

#include <string_view>

namespace crease {

/// `far_depth` as a share of the distance of the far plane: a cleared texel must reach it in spite of
/// rounding.
inline constexpr double far_share = 0.999;

/// How a host writes projection matrices, and which row of the depth image comes first.
struct matrix_convention {
    bool depth_zero_to_one =
        true;          ///< NDC depth in [0, 1] (Vulkan, Direct3D), else in [-1, 1] and stored as z/2 + 1/2
    bool y_up = false; ///< NDC y = -1 is the last row of the image (Direct3D, or Vulkan with a negative
                       ///< viewport height); else it is row 0 (Vulkan, OpenGL)
    bool left_handed = false; ///< view space looks along +Z (Direct3D), else along -Z. That of crease is
                              ///< right-handed: a normal of a left-handed host has its z negated
    bool row_major = false;   ///< rows one after the other, for column vectors; else columns, as GLM has them
};

/// Whether a projection was taken, or why not.
struct [[nodiscard]] projection_result {
    std::string_view error{}; ///< one sentence; empty where it was taken

    /// Whether it was taken.
    constexpr explicit operator bool() const { return error.empty(); }
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

namespace detail {

/// A matrix as crease reads it: column-major, of a right-handed view space.
constexpr void read_matrix(double (&to)[16], const float* from, const matrix_convention& convention) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) {
            const double element = from[convention.row_major ? 4 * row + column : 4 * column + row];
            to[4 * column + row] = convention.left_handed && column == 2 ? -element : element;
        }
}

/// Why a matrix is no projection; empty where it is one.
constexpr std::string_view matrix_error(const double (&m)[16], bool perspective, bool orthographic) {
    for (double element : m)
        if (element - element != 0)
            return "an element of the projection matrix is not finite";
    if (m[11] == 1 && m[15] == 0)
        return "the projection matrix is of a view space of the other handedness: see "
               "matrix_convention::left_handed";
    if (!perspective && !orthographic)
        return (m[14] == -1 || m[14] == 1) && m[15] == 0
                   ? "the projection matrix is transposed: see matrix_convention::row_major"
                   : "the matrix is no projection: its last row must be (0, 0, -1, 0) or (0, 0, 0, 1)";
    if (m[0] == 0 || m[5] == 0 || (perspective ? m[14] : m[10]) == 0)
        return "the projection matrix is singular";
    return {};
}

}

/// Fills a view from a projection matrix, perspective or orthographic, also off-centre, with standard,
/// reversed or infinite-far depth.
/// @param matrix  16 numbers, view space to clip space, such as glm::value_ptr gives; for column vectors its
///                last row is (0, 0, -1, 0), of a left-handed view space (0, 0, 1, 0), or (0, 0, 0, 1)
/// @param width,height  resolution of the picture in texels, > 0
/// @param guard   width of the guard band in texels, by which the depth image is larger than the picture on
///                each side; `matrix` is the picture's, and `widen_projection` makes that of the depth image
/// @return why it is refused, with `v` unchanged: a matrix that is no projection, is singular, not finite or
///         of another convention or sees nothing before the eye, or a size of 0
constexpr projection_result set_projection(view_parameters& v, const float* matrix, unsigned width,
                                           unsigned height, const matrix_convention& convention = {},
                                           unsigned guard = 0) {
    double m[16]{};
    detail::read_matrix(m, matrix, convention);
    const bool perspective = m[11] == -1 && m[15] == 0, orthographic = m[11] == 0 && m[15] == 1;
    if (width == 0 || height == 0)
        return {"the resolution is 0"};
    if (const std::string_view error = detail::matrix_error(m, perspective, orthographic); !error.empty())
        return {error};
    // Device depth is ndc * a + b, so ndc = (z - b) / a.
    const double a = convention.depth_zero_to_one ? 1 : 0.5, b = convention.depth_zero_to_one ? 0 : 0.5;
    // ndc is -m10 + m14 / depth in perspective, else -m10 * depth + m14.
    const double scale = perspective ? 1 / (a * m[14]) : -1 / (a * m[10]);
    const double offset = perspective ? (m[10] - b / a) / m[14] : (m[14] + b / a) / m[10];
    // The far plane is the end of the device range with the greater depth; 1/depth <= 0 there means infinity.
    const double at_zero = static_cast<float>(offset),
                 at_one = static_cast<float>(scale) + static_cast<float>(offset);
    const double least = at_zero < at_one ? at_zero : at_one, most = at_zero < at_one ? at_one : at_zero;
    if (most <= 0)
        return {
            "the projection sees nothing before the eye: it may be of a view space of the other handedness"};
    const double far_depth = !perspective ? most : least > 1e-15 ? 1 / least : 1e15;
    const double shift_x = perspective ? m[8] : -m[12], shift_y = perspective ? m[9] : -m[13];
    // ndc x = 2 * texel / width - 1, and view x = (ndc x + shift) / m0.
    const double flip = convention.y_up ? -1 : 1;
    v.from_texel[0] = static_cast<float>(2 / (width * m[0]));
    v.from_texel[1] = static_cast<float>(flip * 2 / (height * m[5]));
    v.from_texel[2] = static_cast<float>((shift_x - 1) / m[0]);
    v.from_texel[3] = static_cast<float>((shift_y - flip) / m[5]);
    v.depth_unpack[0] = static_cast<float>(scale);
    v.depth_unpack[1] = static_cast<float>(offset);
    v.far_depth = static_cast<float>(far_depth * far_share);
    v.resolution[0] = static_cast<float>(width);
    v.resolution[1] = static_cast<float>(height);
    v.guard = static_cast<float>(guard);
    v.texel_size[0] = 1 / static_cast<float>(width + 2 * guard);
    v.texel_size[1] = 1 / static_cast<float>(height + 2 * guard);
    return {};
}

}
