// SPDX-License-Identifier: MIT
#pragma once

#include <crease/part.hpp>

namespace crease {

/// The numbers of every layer carrier: where its bindings and constants are among those of the host's
/// geometry pass.
inline constexpr number capture_places[] = {
    {"set", 0, 31, 0, "descriptor set of the capture's bindings in the host's geometry pass", false},
    {"first_binding", 0, 1023, 0, "binding of the block of parameters; the others follow", false},
    {"first_constant", 0, 1023, 0, "constant_id of the first number; the others follow", false},
};

}
