// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/symbols.hpp>
#include <crease/effect/array_view.hpp>
#include <crease/effect/pass.hpp>

#include <string>
#include <string_view>

namespace crease {

/// Why names of GLSL cannot begin so; empty where they can.
constexpr std::string_view prefix_error(std::string_view prefix) {
    if (prefix.empty() || (prefix[0] >= '0' && prefix[0] <= '9'))
        return "a prefix of GLSL names must begin with a letter";
    for (char c : prefix)
        if (!reading::is_word(c))
            return "a prefix of GLSL names must be of letters, digits and underscores";
    if (prefix.starts_with("gl_") || prefix.find("__") != std::string_view::npos)
        return "GLSL keeps names that begin with gl_ or hold two underscores to itself";
    return {};
}

/// The text of a pass, with all names that begin with `crease_` beginning with `prefix` in its place: all
/// that it has outside functions.
/// @param prefix  e.g. "near_"; one for which `prefix_error` is empty
inline std::string with_prefix(array_view<const piece> pieces, std::string_view prefix) {
    constexpr std::string_view own = "crease_";
    std::string text;
    for (const piece& each : pieces) {
        std::size_t done = 0;
        for (std::size_t at = each.text.find(own); at != std::string_view::npos;
             at = each.text.find(own, at + 1)) {
            if (at > 0 && reading::is_word(each.text[at - 1]))
                continue;
            text.append(each.text.substr(done, at - done)).append(prefix);
            done = at + own.size();
        }
        text.append(each.text.substr(done));
    }
    return text;
}

}
