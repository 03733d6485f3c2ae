// SPDX-License-Identifier: MIT
#include "scene/shown.hpp"

#include <algorithm>

namespace crease::tools {

std::string shown(std::string_view text) {
    constexpr std::size_t longest = 60;
    std::string line(text.substr(0, longest));
    std::ranges::replace_if(
        line, [](char c) { return static_cast<unsigned char>(c) < ' '; }, '?');
    return text.size() > longest ? line + "..." : line;
}

}
