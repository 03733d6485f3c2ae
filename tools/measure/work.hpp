// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv.hpp>

namespace crease::tools {

/// The most that one invocation of a shader can do: every branch taken, every loop run to its end.
struct shader_work {
    unsigned instructions =
        0; ///< SPIR-V instructions of its function after optimisation, labels and branches left out
    unsigned fetches = 0; ///< of these, reads of images
    bool counted_whole =
        true; ///< false where a loop runs a number of times that is no constant: it counts once
};

/// Counts the work of a module with its specialization constants at their defaults.
shader_work count_work(const spirv::words& module);

}
