// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace crease {

/// One GLSL file, as text with static storage.
///
/// A file is written so that C++ can include it as one raw string literal and GLSL can read it as it is. It
/// has two halves: the contract, prototypes of what it calls, which C++ skips (`#ifndef __cplusplus`), and
/// the body, which for GLSL stands between fences: `#else`, `__LINE__, R"glsl("`, `#endif` before it. A
/// host's own part may also pass plain GLSL without a fence.
struct glsl_file {
    std::string_view name;   ///< path below templates/crease, e.g. "estimator/hbao.glsl"; what an error names
    std::string_view text;   ///< the body; ends with a newline
    unsigned first_line = 1; ///< line of the file at which `text` begins

    constexpr glsl_file() = default;
    /// Text without a fence.
    constexpr glsl_file(std::string_view file, std::string_view glsl) : name(file), text(glsl) {}
    /// A file that was included: the line of its opening fence, and the literal.
    // A compiler knows the length of a literal; anything else it counts and compares character by character.
    constexpr glsl_file(std::string_view file, unsigned fence, const char* literal)
        : name(file), text(literal + opening, __builtin_strlen(literal) - opening - closing),
          first_line(fence + 2) {}

    /// A literal longer than this is refused by MSVC, so no part may exceed it.
    static constexpr std::size_t longest = 16380;

private:
    static constexpr std::size_t opening = sizeof "\"\n#endif\n" - 1,
                                 closing = sizeof "#ifdef __cplusplus\n\"" - 1;
};

}
