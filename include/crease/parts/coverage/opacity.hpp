// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// What every coverage reads.
inline constexpr setting opacity_setting[] = {
    {"opacity", 0.2f, 0.001f, 1, "probability that a sample keeps a fragment, alpha", true}};

}
