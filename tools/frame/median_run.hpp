// SPDX-License-Identifier: MIT
#pragma once

#include "frame/frame.hpp"

namespace crease::tools {

/// Milliseconds of all passes of an effect, by the median of the repeats; a first run, which compiles, is
/// left out.
double median_run(vulkan::runner& runner, unsigned repeats);

}
