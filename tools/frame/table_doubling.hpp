// SPDX-License-Identifier: MIT
#pragma once

#include "frame/frame.hpp"

namespace crease::tools {

/// Milliseconds of a summed-area table of rgba32_float by recursive doubling, each pass of which adds to
/// every texel the one at twice the distance of the pass before: what the scan of the tables is measured
/// against. All passes together; the median of the repeats.
double time_table_doubling(vulkan::device& device, unsigned width, unsigned height, unsigned repeats);

}
