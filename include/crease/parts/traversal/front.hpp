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
    static constexpr number takes[] = {{"angle", 0, 1, 1,
                                        "1: not behind a front surface where the estimator says that nothing "
                                        "behind can matter; 0: there too"}};
    static constexpr setting reads[] = {
        {"reach", 0.3f, 0, 1,
         "up to which distance of a front surface nothing behind it is looked at, radii"},
    };
};

}
