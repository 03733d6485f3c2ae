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
    // A compiler knows the length of a literal, and std::string_view counts it character by character.
    constexpr glsl_file(std::string_view file, const char* literal)
        : glsl_file(file, std::string_view(literal, __builtin_strlen(literal))) {}
    constexpr glsl_file(std::string_view file, std::string_view glsl) : name(file), text(glsl) {
        constexpr std::string_view opening = "\"\n#endif\n", closing = "#ifdef __cplusplus\n\"";
        if (text.starts_with(opening) && text.ends_with(closing)) {
            text.remove_prefix(opening.size());
            text.remove_suffix(closing.size());
            first_line = 4;
        }
    }

    /// A literal longer than this is refused by MSVC, so no part may exceed it.
    static constexpr std::size_t longest = 16380;
};

}
