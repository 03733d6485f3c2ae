// SPDX-License-Identifier: MIT
#include "scene/obj_lines.hpp"

#include "scene/scene.hpp"
#include "scene/shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string>

namespace crease::tools {
namespace {

constexpr std::string_view blanks = " \t\f\v\r\n\\";

bool goes_on(std::string_view line) {
    return line.ends_with('\\') || line.ends_with("\\\r");
}

}

obj_lines::obj_lines(std::string_view text) : rest_(text) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (rest_.starts_with(byte_order_mark))
        rest_.remove_prefix(byte_order_mark.size());
    break_ = rest_.find('\n') == rest_.npos ? '\r' : '\n';
}

bool obj_lines::next() {
    if (rest_.empty())
        return false;
    std::size_t end = 0;
    do {
        end = std::min(rest_.find(break_, end), rest_.size() - 1) + 1;
        ++number_;
    } while (end < rest_.size() && goes_on(rest_.substr(0, end - 1)));
    words_ = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return true;
}

std::string_view obj_lines::word() {
    words_.remove_prefix(std::min(words_.find_first_not_of(blanks), words_.size()));
    const std::string_view found = words_.substr(0, words_.find_first_of(blanks));
    words_.remove_prefix(found.size());
    return found;
}

std::string_view obj_lines::rest() const {
    const std::size_t begin = std::min(words_.find_first_not_of(blanks), words_.size());
    return words_.substr(begin, words_.find_last_not_of(blanks) + 1 - begin);
}

void obj_lines::fail(std::string_view sentence) const {
    throw scene_error(fmt::format("line {}: {}; export it again", number_, sentence));
}

double number_of(const obj_lines& line, std::string_view word, std::string_view missing) {
    double value = 0;
    const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range)
        return std::strtod(std::string(digits).c_str(), nullptr); // infinite, or nearly 0
    if (error != std::errc() || end != digits.data() + digits.size())
        line.fail(word.empty() ? std::string(missing) : fmt::format("'{}' is not a number", shown(word)));
    return value;
}

}
