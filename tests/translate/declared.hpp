// SPDX-License-Identifier: MIT
// What a text in another language declares, read from the text alone.
#pragma once

#include <crease/translate.hpp>

#include <map>
#include <sstream>
#include <string>
#include <string_view>

/// The numbers in a text: "t3", "s0", "b0 space1", "buffer 0", "texture 1", "binding 2" by identifier. In MSL
/// these are the arguments of the entry point.
class declared_numbers {
public:
    explicit declared_numbers(const crease::translate::translation& made) {
        std::istringstream lines(made.text);
        for (std::string line; std::getline(lines, line);)
            if (made.made_for.to == crease::translate::language::hlsl)
                read_register(line);
            else if (made.made_for.to == crease::translate::language::msl)
                read_arguments(line, " " + made.entry_point + "(");
            else
                read_layout(line);
    }

    std::map<std::string, std::string> all;

private:
    static bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
    static std::string last_word(std::string_view text) {
        while (!text.empty() && !is_word(text.back()))
            text.remove_suffix(1);
        std::size_t first = text.size();
        while (first > 0 && is_word(text[first - 1]))
            --first;
        return std::string(text.substr(first));
    }
    /// What stands between two texts, the first of which has been found.
    static std::string between(const std::string& line, std::size_t first, std::string_view end) {
        return line.substr(first, line.find(end, first) - first);
    }

    void read_register(const std::string& line) {
        constexpr std::string_view mark = " : register(";
        const std::size_t at = line.find(mark);
        if (at == line.npos)
            return;
        std::string place = between(line, at + mark.size(), ")");
        if (const std::size_t comma = place.find(','); comma != place.npos)
            place.erase(comma, 1);
        all[last_word(line.substr(0, at))] = place;
    }

    void read_arguments(const std::string& line, const std::string& name) {
        if (line.find(name) == line.npos)
            return;
        for (const std::string kind : {"buffer", "texture", "sampler"})
            for (std::size_t at = line.find("[[" + kind + "("); at != line.npos;
                 at = line.find("[[" + kind + "(", at + 1)) {
                const std::size_t number = at + 3 + kind.size();
                all[last_word(line.substr(0, at))] = kind + " " + between(line, number, ")");
            }
    }

    void read_layout(const std::string& line) {
        constexpr std::string_view mark = "binding = ";
        const std::size_t at = line.find(mark);
        if (at != line.npos && line.starts_with("layout("))
            all[last_word(line)] = "binding " + between(line, at + mark.size(),
                                                        line.find(',', at) < line.find(')', at) ? "," : ")");
    }
};

/// The same of what a translation tells, written out from the words of its language.
inline std::map<std::string, std::string> told_numbers(const crease::translate::translation& made) {
    using namespace crease::translate;
    std::map<std::string, std::string> all;
    const target& to = made.made_for;
    if (to.to == language::glsl_es && to.version < 310)
        return all; // has no layout for it: the host looks names up
    for (const placed_binding& b : made.bindings) {
        const std::string number = std::to_string(b.number),
                          space = to.version > 50 ? " space" + std::to_string(b.space) : "";
        switch (b.kind) {
        case number_kind::b_register:
            all[b.identifier] = "b" + number + space;
            break;
        case number_kind::t_register:
            all[b.identifier] = "t" + number + space;
            break;
        case number_kind::u_register:
            all[b.identifier] = "u" + number + space;
            break;
        case number_kind::buffer_index:
            all[b.identifier] = "buffer " + number;
            break;
        case number_kind::texture_index:
            all[b.identifier] = "texture " + number;
            break;
        default:
            all[b.identifier] = "binding " + number;
        }
        if (b.sampler && to.to == language::hlsl)
            all["_" + b.identifier + "_sampler"] = "s" + std::to_string(*b.sampler) + space;
        else if (b.sampler)
            all[b.identifier + "Smplr"] = "sampler " + std::to_string(*b.sampler);
    }
    if (made.buffer_sizes)
        all["spvBufferSizeConstants"] = "buffer " + std::to_string(*made.buffer_sizes);
    return all;
}
