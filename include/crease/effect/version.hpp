// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace crease {

inline constexpr std::string_view version = "0.1.0";

}
