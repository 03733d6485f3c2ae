// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/parameters.hpp>

/// Parameters for a runner of this size, in texels.
inline crease::parameters sized(unsigned width, unsigned height, unsigned guard = 0) {
    crease::parameters p;
    p.view.resolution[0] = static_cast<float>(width);
    p.view.resolution[1] = static_cast<float>(height);
    p.view.guard = static_cast<float>(guard);
    return p;
}
