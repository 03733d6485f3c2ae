// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace crease {

/// One GLSL file, as text with static storage.
///
/// A file is written so that C++ can include it as one raw string literal and GLSL can read it as it is:
/// three lines of fence before the text (`#ifdef __cplusplus`, `R"glsl("`, `#endif`) and three after it. A
/// host's own part may also pass plain GLSL without a fence.
struct glsl_file {
    std::string_view name;   ///< path below templates/crease, e.g. "estimator/hbao.glsl"; what an error names
    std::string_view text;   ///< the GLSL between the fences; ends with a newline
    unsigned first_line = 1; ///< line of the file at which `text` begins

    constexpr glsl_file() = default;
    /// Text without a fence.
    constexpr glsl_file(std::string_view file, std::string_view glsl) : name(file), text(glsl) {}
    /// A literal: a file that was included, with its fence, or GLSL without one.
    // A compiler knows the length of a literal; anything else it counts and compares character by character.
    constexpr glsl_file(std::string_view file, const char* literal)
        : name(file), text(literal, __builtin_strlen(literal)) {
        constexpr std::size_t opening = sizeof "\"\n#endif\n" - 1,
                              closing = sizeof "#ifdef __cplusplus\n\"" - 1;
        if (literal[0] == '"') { // GLSL has none
            text = {literal + opening, text.size() - opening - closing};
            first_line = 4;
        }
    }

    /// A literal longer than this is refused by MSVC, so no part may exceed it.
    static constexpr std::size_t longest = 16380;
};

}
