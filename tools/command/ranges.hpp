// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <string>

namespace crease::tools {

namespace detail {

/// Refuses all but one number in a range, NaN too, with the range in the sentence.
template <class Number>
CLI::Validator within(const char* what, Number least, Number most) {
    const std::string range = fmt::format("{} from {} to {}", what, least, most);
    return {[=](std::string& text) {
                Number value{};
                const char* end = text.data() + text.size();
                const auto read = std::from_chars(text.data(), end, value);
                return read.ec == std::errc{} && read.ptr == end && value >= least && value <= most
                           ? std::string()
                           : fmt::format("'{}' is not {}", text, range);
            },
            range, "number"};
}

}

/// Of options that take a number.
inline CLI::Validator number_from(double least, double most) {
    return detail::within("a number", least, most);
}

/// Of options that take a whole number.
inline CLI::Validator whole_number_from(unsigned least, unsigned most) {
    return detail::within("a whole number", least, most);
}

}
