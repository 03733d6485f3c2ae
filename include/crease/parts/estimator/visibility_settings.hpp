// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// How strongly occlusion darkens, with the value that an estimator recommends.
constexpr setting strength_setting(float fallback, float most = 16) {
    return {"strength", fallback, 0, most, "factor of the occlusion", true};
}

/// The contrast of visibility, with the value that an estimator recommends.
constexpr setting exponent_setting(float fallback) {
    return {"exponent", fallback, 0.01f, 16, "power of the visibility", true};
}

}
