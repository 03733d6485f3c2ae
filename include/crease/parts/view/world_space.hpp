// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/parameters.hpp>
#include <crease/parts/view/normal_image.hpp>

namespace crease {

inline constexpr glsl_file world_space_glsl{
    "view/world_space.glsl",
#include <crease/view/world_space.glsl>
};

/// The settings of parts that are given normals in world space: the rotation to view space, element by
/// element.
inline constexpr setting world_settings[] = {
    {"world_xx", 1, -1.01f, 1.01f, "x of view space per x of world space", true},
    {"world_xy", 0, -1.01f, 1.01f, "x of view space per y of world space", true},
    {"world_xz", 0, -1.01f, 1.01f, "x of view space per z of world space", true},
    {"world_yx", 0, -1.01f, 1.01f, "y of view space per x of world space", true},
    {"world_yy", 1, -1.01f, 1.01f, "y of view space per y of world space", true},
    {"world_yz", 0, -1.01f, 1.01f, "y of view space per z of world space", true},
    {"world_zx", 0, -1.01f, 1.01f, "z of view space per x of world space", true},
    {"world_zy", 0, -1.01f, 1.01f, "z of view space per y of world space", true},
    {"world_zz", 1, -1.01f, 1.01f, "z of view space per z of world space", true},
};

/// Sets the rotation from world to view space of an effect that is given normals in world space.
/// @param matrix  16 numbers, world space to view space without a scale, as `convention` says; of a
/// left-handed
///                view space z is negated
/// @return false, with `p` unchanged, where the effect takes none, or the matrix has a scale or is not finite
constexpr bool set_world_to_view(parameters& p, array_view<const effect_setting> settings,
                                 const float* matrix, const matrix_convention& convention = {}) {
    parameters turned = p;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column) {
            const float element = matrix[convention.row_major ? 4 * row + column : 4 * column + row];
            if (!set(turned, settings, world_settings[3 * row + column].name,
                     convention.left_handed && row == 2 ? -element : element))
                return false;
        }
    p = turned;
    return true;
}

}
