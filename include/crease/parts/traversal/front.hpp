// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>

namespace crease {

inline constexpr glsl_file front_glsl{
    "traversal/front.glsl",
#include <crease/traversal/front.glsl>
};

/// What the traversals have in common that look at the front surface before the layers behind it.
struct front_part {
    static constexpr number takes[] = {
        {"angle", 0, 1, 1,
         "1: behind a front surface that hides all from the estimator nothing is looked for; 0: it is"}};
    static constexpr setting reads[] = {
        {"reach", 0.3f, 0, 1, "nothing is looked for behind a front surface nearer to the receiver, radii"},
    };
};

}
