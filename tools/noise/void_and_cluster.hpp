// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace crease::tools {

/// A tile of blue noise, which repeats without a seam: the places of a square in the order in which
/// void-and-cluster fills them, after Ulichney 1993, "The void-and-cluster method for dither array
/// generation". The same on every machine.
/// @param side  texels, >= 2
/// @return of each texel, row by row, its rank from 0 to side * side - 1
std::vector<std::uint16_t> void_and_cluster(unsigned side);

}
