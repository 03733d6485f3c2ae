// SPDX-License-Identifier: MIT
#pragma once

#include "corner.hpp"

#include <crease/effect/effect_view.hpp>

#include <stdexcept>
#include <string>

/// The camera of the engines in Vulkan, with Vulkan's own clip space: y down, so row 0 is the highest; depth
/// reversed, the far plane at infinity.
namespace camera {

inline constexpr crease::matrix_convention clip{.depth_zero_to_one = true};
inline constexpr picture::matrix projection = {1, 0, 0, 0, 0, -16.f / 9, 0, 0, 0, 0, 0, -1, 0, 0, 0.1f, 0};

/// The depth buffer of the corner, row 0 first.
inline std::vector<float> depth() {
    return corner::device_depth(projection, clip);
}

/// What an effect is given to show the corner.
inline crease::parameters parameters_for(const crease::effect_view& effect) {
    crease::parameters values = effect.defaults;
    const auto fit = crease::set_projection(values.view, projection, picture::width, picture::height, clip);
    if (!fit)
        throw std::runtime_error(std::string(fit.error));
    values.radius = corner::radius;
    return values;
}

}
