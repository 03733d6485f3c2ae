// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace crease::tools {

/// A text of a file as a message may show it: short and of one line.
std::string shown(std::string_view text);

}
