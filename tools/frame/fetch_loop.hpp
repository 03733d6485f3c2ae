// SPDX-License-Identifier: MIT
#pragma once

#include "frame/frame.hpp"

namespace crease::tools {

/// Milliseconds of a pass that does nothing but read the depth of each texel of a picture 32 times, at fixed
/// offsets: the limit that an estimator with 32 taps cannot pass. The median of the repeats.
double time_fetch_loop(vulkan::device& device, const gbuffer& inputs, unsigned repeats);

}
