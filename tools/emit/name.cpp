// SPDX-License-Identifier: MIT
#include "name.hpp"

#include "recipe_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace crease::tools {

namespace {

constexpr std::string_view taken[] = {
#include "crease_reserved_names.inc"
};

constexpr bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

constexpr bool is_letter_or_digit(char c) {
    return is_letter(c) || (c >= '0' && c <= '9');
}

std::string_view fault_of(std::string_view name) {
    if (name.empty() || !is_letter(name[0]) || !std::ranges::all_of(name, is_letter_or_digit))
        return "is no C++ identifier: letters, digits and '_', a letter first";
    if (name[0] == '_' || name.find("__") != std::string_view::npos)
        return "is reserved to compilers, as are all names that begin with '_' or hold '__'";
    return std::ranges::find(taken, name) != std::end(taken)
               ? "is a word of C++, or a name or macro of another's"
               : std::string_view();
}

}

void expect_name(std::string_view name) {
    if (const std::string_view fault = fault_of(name); !fault.empty())
        throw recipe_error(fmt::format("the name '{}' {}", name, fault));
}

}
