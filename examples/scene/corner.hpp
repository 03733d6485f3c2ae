// SPDX-License-Identifier: MIT
#pragma once

#include "picture.hpp"

#include <crease/effect/projection.hpp>

#include <algorithm>
#include <iostream>

/// Stands for the engine's G-buffer: a floor, a wall and a box, seen in perspective.
namespace corner {

inline constexpr float radius = 0.8f; // of the ambient occlusion, in the units of the scene

/// Distance along the view direction to what the ray through (x, y, -1) hits.
inline float depth_along(float x, float y) {
    constexpr float wall = 5, least[] = {0.2f, -1, -4.2f}, most[] = {1.2f, -0.2f, -3.2f};
    const float room = y < 0 ? std::min(-1 / y, wall) : wall; // the floor is at y = -1
    const float ray[] = {x, y, -1};
    float enter = 0, leave = room;
    for (int axis = 0; axis < 3; ++axis) {
        const float one = least[axis] / ray[axis], other = most[axis] / ray[axis];
        enter = std::max(enter, std::min(one, other));
        leave = std::min(leave, std::max(one, other));
    }
    return enter < leave ? enter : room;
}

/// The depth buffer that a rasteriser with this projection would leave, row 0 first.
inline std::vector<float> device_depth(const picture::matrix& projection, crease::matrix_convention clip) {
    std::vector<float> texels;
    for (unsigned j = 0; j < picture::height; ++j)
        for (unsigned i = 0; i < picture::width; ++i) {
            const float ndc_x = 2 * (static_cast<float>(i) + 0.5f) / picture::width - 1;
            const float ndc_y = 2 * (static_cast<float>(j) + 0.5f) / picture::height - 1;
            const float depth = depth_along(ndc_x / projection[0], ndc_y / projection[5]);
            const float ndc_z = projection[14] / depth - projection[10];
            texels.push_back(clip.depth_zero_to_one ? ndc_z : 0.5f * ndc_z + 0.5f);
        }
    return texels;
}

/// Whether the visibility is as the scene asks for; says what it is.
inline bool plausible(const std::vector<std::uint8_t>& visibility, const picture::matrix& projection) {
    const float floor = picture::mean_around(visibility, projection, -0.8f, -1, 2.5f);
    const float edge = picture::mean_around(visibility, projection, -0.8f, -1, 4.97f);
    std::cout << "visibility of the open floor " << floor << ", where it meets the wall " << edge << '\n';
    return floor > 0.98f && edge < 0.8f && edge > 0.3f;
}

}
