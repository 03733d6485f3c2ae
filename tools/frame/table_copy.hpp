// SPDX-License-Identifier: MIT
#pragma once

#include "frame/frame.hpp"

namespace crease::tools {

/// Milliseconds of a pass that copies an image of rgba32_float texels and does nothing else: the limit that
/// one pass over a summed-area table cannot pass. The median of the repeats.
double time_table_copy(vulkan::device& device, unsigned width, unsigned height, unsigned repeats);

}
