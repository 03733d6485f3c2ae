// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace crease::tools {

/// A recipe that cannot be run or emitted as it was asked for, or an option that does not fit it: the
/// arguments are wrong, and commands end with 2.
struct recipe_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}
