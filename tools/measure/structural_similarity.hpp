// SPDX-License-Identifier: MIT
#pragma once

#include "image/image.hpp"

#include <vector>

namespace crease::tools {

/// Mean structural similarity (Wang et al. 2004) of one channel, over every 8 x 8 window, of equal weights,
/// that lies in the mask as a whole, with k1 = 0.01 and k2 = 0.03.
/// @param mask one entry a texel, row by row: whether it counts; both images must be finite there
/// @param peak the range of the values
/// @return NaN where there is no such window
double structural_similarity(const image& a, const image& b, unsigned channel, const std::vector<bool>& mask,
                             double peak);

}
