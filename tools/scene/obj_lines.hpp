// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace crease::tools {

/// Lines of a Wavefront file, .obj or .mtl; one that ends in a backslash goes on in the next.
class obj_lines {
public:
    explicit obj_lines(std::string_view text);

    /// @return false at the end of the file
    bool next();

    /// Takes the next word off the line; empty at its end.
    std::string_view word();

    /// The words that are left, as they stand.
    std::string_view rest() const;

    /// @throws scene_error  of this line
    [[noreturn]] void fail(std::string_view sentence) const;

private:
    std::string_view rest_, words_;
    char break_;
    std::size_t number_ = 0;
};

/// The number that a word of a line is.
/// @param missing  the sentence where the word is empty
/// @throws scene_error
double number_of(const obj_lines& line, std::string_view word, std::string_view missing);

}
