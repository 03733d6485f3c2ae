// SPDX-License-Identifier: MIT
#include "scene/obj.hpp"

#include "scene/limits.hpp"
#include "scene/polygon.hpp"
#include "scene/shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace crease::tools {
namespace {

/// Lines of a file; one that ends in a backslash goes on in the next.
class lines {
public:
    explicit lines(std::string_view text) : rest_(text) {
        constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
        if (rest_.starts_with(byte_order_mark))
            rest_.remove_prefix(byte_order_mark.size());
        break_ = rest_.find('\n') == rest_.npos ? '\r' : '\n';
    }

    /// @return false at the end of the file
    bool next() {
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

    /// Takes the next word off the line; empty at its end.
    std::string_view word() {
        constexpr std::string_view blanks = " \t\f\v\r\n\\";
        words_.remove_prefix(std::min(words_.find_first_not_of(blanks), words_.size()));
        const std::string_view found = words_.substr(0, words_.find_first_of(blanks));
        words_.remove_prefix(found.size());
        return found;
    }

    [[noreturn]] void fail(std::string_view sentence) const {
        throw scene_error(fmt::format("line {}: {}; export it again", number_, sentence));
    }

private:
    static bool goes_on(std::string_view line) { return line.ends_with('\\') || line.ends_with("\\\r"); }

    std::string_view rest_, words_;
    char break_;
    std::size_t number_ = 0;
};

double number(const lines& line, std::string_view word) {
    double value = 0;
    const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range)
        return std::strtod(std::string(digits).c_str(), nullptr); // infinite, or nearly 0
    if (error != std::errc() || end != digits.data() + digits.size())
        line.fail(word.empty() ? "a vertex needs three numbers"
                               : fmt::format("'{}' is not a number", shown(word)));
    return value;
}

/// The vertex of a corner "v", "v/vt", "v//vn" or "v/vt/vn".
std::uint32_t vertex(const lines& line, std::string_view corner, std::size_t above, std::size_t all) {
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(corner.data(), corner.data() + corner.size(), index);
    const bool is_read = error == std::errc() && (end == corner.data() + corner.size() || *end == '/');
    const std::int64_t place = index < 0 ? static_cast<std::int64_t>(above) + index : index - 1;
    if (!is_read || place < 0 || place >= static_cast<std::int64_t>(all))
        line.fail(fmt::format("'{}' is not one of the {} vertices", shown(corner), index < 0 ? above : all));
    return static_cast<std::uint32_t>(place);
}

std::vector<glm::dvec3> positions_of(std::string_view file) {
    std::vector<glm::dvec3> all;
    for (lines line(file); line.next();) {
        if (line.word() != "v")
            continue;
        if (all.size() == most_vertices)
            throw scene_error(fmt::format("has more than {} vertices; simplify it", most_vertices));
        glm::dvec3& position = all.emplace_back();
        for (int i = 0; i < 3; ++i)
            position[i] = number(line, line.word());
        for (std::string_view more = line.word(); !more.empty(); more = line.word())
            number(line, more); // a weight or a colour
    }
    return all;
}

}

mesh read_obj(std::string_view file) {
    mesh made{.positions = positions_of(file), .indices = {}};
    triangulator polygons(made);
    std::vector<std::uint32_t> face;
    std::size_t above = 0;
    for (lines line(file); line.next();) {
        const std::string_view kind = line.word();
        above += kind == "v";
        if (kind != "f")
            continue;
        face.clear();
        for (std::string_view corner = line.word(); !corner.empty(); corner = line.word())
            face.push_back(vertex(line, corner, above, made.positions.size()));
        polygons.add(face);
    }
    return made;
}

}
