// SPDX-License-Identifier: MIT
#pragma once

#include "frame/frame.hpp"

namespace crease::tools {

/// Milliseconds of all passes of an effect together: the median of the repeats, without a first run, which
/// compiles.
double median_run(vulkan::runner& runner, unsigned repeats);

}
