// SPDX-License-Identifier: MIT
#include "scene/mtl.hpp"

#include "scene/obj_lines.hpp"
#include "scene/shown.hpp"

#include <fmt/format.h>

namespace crease::tools {
namespace {

float share(const obj_lines& line, std::string_view word) {
    const double value = number_of(line, word, "a number from 0 to 1 is missing");
    if (!(value >= 0 && value <= 1))
        line.fail(fmt::format("'{}' is not a number from 0 to 1", shown(word)));
    return static_cast<float>(value);
}

/// The numbers of "Kd", where they are not those of a spectrum or of CIE XYZ; one stands for all three.
void read_diffuse(obj_lines& line, glm::vec4& colour) {
    std::string_view word = line.word();
    if (word == "spectral" || word == "xyz")
        return;
    for (int i = 0; i < 3; ++i) {
        colour[i] = i > 0 && word.empty() ? colour[i - 1] : share(line, word);
        word = line.word();
    }
}

}

mtl_materials read_mtl(std::string_view file) {
    mtl_materials all;
    material* current = nullptr;
    bool has_opacity = false; // which counts before its complement
    for (obj_lines line(file); line.next();) {
        const std::string_view kind = line.word();
        if (kind == "newmtl") {
            current = &(all[std::string(line.rest())] = {});
            has_opacity = false;
        }
        if (!current)
            continue;
        if (kind == "Kd")
            read_diffuse(line, current->colour);
        if (kind == "d") {
            const std::string_view word = line.word();
            current->colour.a = share(line, word == "-halo" ? line.word() : word);
            has_opacity = true;
        }
        if (kind == "Tr")
            if (const float complement = share(line, line.word()); !has_opacity)
                current->colour.a = 1 - complement;
    }
    return all;
}

}
