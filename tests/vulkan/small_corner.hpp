// SPDX-License-Identifier: MIT
#pragma once

#include "corner.hpp"

#include <crease/effect/effect_view.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

/// The corner of the examples, in a picture that a test has the time for.
namespace small_corner {

inline constexpr unsigned width = 96, height = 54;
inline constexpr picture::matrix projection = {1, 0, 0, 0, 0, -16.f / 9, 0, 0, 0, 0, 0, -1, 0, 0, 0.1f, 0};

inline std::vector<float> device_depth() {
    std::vector<float> texels;
    for (unsigned j = 0; j < height; ++j)
        for (unsigned i = 0; i < width; ++i) {
            const float x = (2 * (static_cast<float>(i) + 0.5f) / width - 1) / projection[0];
            const float y = (2 * (static_cast<float>(j) + 0.5f) / height - 1) / projection[5];
            texels.push_back(projection[14] / corner::depth_along(x, y));
        }
    return texels;
}

inline crease::parameters parameters_for(const crease::effect_view& effect) {
    crease::parameters values = effect.defaults;
    if (const auto fit = crease::set_projection(values.view, projection, width, height); !fit)
        throw std::runtime_error(std::string(fit.error));
    values.radius = corner::radius;
    return values;
}

/// How far apart two pictures of the same size are where they are the farthest.
inline float largest_difference(const std::vector<float>& one, const std::vector<float>& other) {
    float largest = one.size() == other.size() ? 0 : HUGE_VALF;
    for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i)
        largest = std::max(largest, std::abs(one[i] - other[i]));
    return largest;
}

/// What rounding to r8 may make of two sums in another order.
inline constexpr float a_step = 1.001f / 255;

}
