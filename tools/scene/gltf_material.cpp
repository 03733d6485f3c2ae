// SPDX-License-Identifier: MIT
#include "scene/gltf_material.hpp"

#include "scene/shown.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace crease::tools {
namespace {

glm::vec4 base_colour_of(const gltf_value& of) {
    glm::vec4 colour(1);
    if (!of.has("pbrMetallicRoughness") || !of["pbrMetallicRoughness"].has("baseColorFactor"))
        return colour;
    const gltf_value factor = of["pbrMetallicRoughness"]["baseColorFactor"];
    const std::vector<double> numbers = factor.numbers(4);
    if (!std::ranges::all_of(numbers, [](double n) { return n >= 0 && n <= 1; }))
        factor.fail("must be four numbers from 0 to 1");
    for (int i = 0; i < 4; ++i)
        colour[i] = static_cast<float>(numbers[static_cast<std::size_t>(i)]);
    return colour;
}

double cutoff_of(const gltf_value& of) {
    if (!of.has("alphaCutoff"))
        return 0.5;
    const double cutoff = of["alphaCutoff"].number();
    if (!(cutoff >= 0))
        of["alphaCutoff"].fail("must not be negative");
    return cutoff;
}

}

std::optional<material> read_gltf_material(const gltf_value& of) {
    material made{base_colour_of(of)};
    const double cutoff = cutoff_of(of);
    if (of.has("doubleSided"))
        of["doubleSided"].flag(); // which must be one
    const std::string_view mode = of.has("alphaMode") ? of["alphaMode"].text() : "OPAQUE";
    if (mode == "BLEND")
        return made;
    if (mode != "OPAQUE" && mode != "MASK")
        of["alphaMode"].fail(fmt::format("is '{}', and must be OPAQUE, MASK or BLEND", shown(mode)));
    if (mode == "MASK" && double{made.colour.a} < cutoff)
        return std::nullopt;
    made.colour.a = 1;
    return made;
}

}
