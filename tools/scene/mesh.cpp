// SPDX-License-Identifier: MIT
#include "image/file.hpp"
#include "scene/gltf.hpp"
#include "scene/limits.hpp"
#include "scene/obj.hpp"
#include "scene/scene.hpp"
#include "scene/shown.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace crease::tools {
namespace {

bool is_near_enough(const glm::dvec3& p) {
    const auto holds = [](double x) { return std::abs(x) <= farthest_coordinate; }; // false for NaN
    return holds(p.x) && holds(p.y) && holds(p.z);
}

bool is_colour(const glm::vec4& c) {
    const auto holds = [](float x) { return x >= 0 && x <= 1; }; // false for NaN
    return holds(c.r) && holds(c.g) && holds(c.b) && holds(c.a);
}

/// The extension in lower case, where it is one that is read.
std::string known_extension(std::string_view extension, std::string_view name) {
    std::string lower(extension);
    std::ranges::transform(lower, lower.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    if (lower != "glb" && lower != "gltf" && lower != "obj")
        throw scene_error(
            fmt::format("{}: cannot read '.{}' scenes; use .glb, .gltf or .obj", name, extension));
    return lower;
}

/// A sentence that says which names there are.
std::string names_in(const mesh& scene) {
    constexpr std::size_t most = 20;
    std::set<std::string_view> all;
    for (const named_triangles& each : scene.named)
        all.insert(each.name);
    if (all.empty())
        return "the scene names none";
    std::string sentence = "there are";
    std::size_t count = 0;
    for (const std::string_view name : all)
        if (++count <= most)
            sentence += fmt::format("{} '{}'", count > 1 ? "," : "", shown(name));
    return count > most ? fmt::format("{} and {} more", sentence, count - most) : sentence;
}

/// @param folder  where further files are; null where none may be read
mesh parse(std::string_view bytes, const std::string& extension, std::string_view name,
           const std::filesystem::path* folder) {
    mesh made;
    try {
        made = extension == "obj" ? read_obj(bytes, folder) : read_gltf(bytes, folder);
    } catch (const scene_error& error) {
        throw scene_error(fmt::format("{}: {}", name, error.what()));
    }
    check_mesh(made, name);
    return made;
}

}

void add_triangle(mesh& to, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::vector<glm::dvec3>& p = to.positions;
    if (glm::cross(p[b] - p[a], p[c] - p[a]) == glm::dvec3(0)) // false for NaN, which check_mesh reports
        return;
    if (to.triangles() == most_triangles)
        throw scene_error(fmt::format("has more than {} triangles; simplify it", most_triangles));
    to.indices.insert(to.indices.end(), {a, b, c});
}

void check_mesh(const mesh& scene, std::string_view name) {
    if (scene.indices.size() < 3)
        throw scene_error(fmt::format("{}: has no triangles", name));
    if (scene.indices.size() % 3 != 0)
        throw scene_error(
            fmt::format("{}: has {} indices, which is not a multiple of 3", name, scene.indices.size()));
    const auto broken = std::find_if_not(scene.positions.begin(), scene.positions.end(), is_near_enough);
    if (broken != scene.positions.end())
        throw scene_error(
            fmt::format("{}: the position of vertex {} is not finite, or beyond {:g}; export it again", name,
                        broken - scene.positions.begin(), farthest_coordinate));
    for (const material& each : scene.materials)
        if (!is_colour(each.colour))
            throw scene_error(fmt::format(
                "{}: a material's colour has a number that is not from 0 to 1; export it again", name));
    if (std::ranges::any_of(scene.material_ids,
                            [&](std::uint32_t id) { return id >= scene.materials.size(); }))
        throw scene_error(
            fmt::format("{}: a triangle is of a material that is not there; export it again", name));
    const std::uint32_t last = *std::max_element(scene.indices.begin(), scene.indices.end());
    if (last >= scene.positions.size())
        throw scene_error(fmt::format("{}: a triangle uses vertex {} of a mesh that has {}; export it again",
                                      name, last, scene.positions.size()));
}

void paint(mesh& to, const material& with) {
    if (to.material_ids.size() >= to.triangles())
        return;
    if (to.materials.empty() || to.materials.back() != with)
        to.materials.push_back(with);
    to.material_ids.resize(to.triangles(), static_cast<std::uint32_t>(to.materials.size() - 1));
}

void set_dynamic(mesh& of, std::size_t first, std::size_t end) {
    if (of.dynamic.size() < end)
        of.dynamic.resize(end);
    std::fill(of.dynamic.begin() + static_cast<std::ptrdiff_t>(first),
              of.dynamic.begin() + static_cast<std::ptrdiff_t>(end), true);
}

mesh with_dynamic(mesh scene, std::span<const std::string> names, std::string_view label) {
    for (const std::string& name : names) {
        bool is_there = false;
        for (const named_triangles& each : scene.named)
            if (each.name == name) {
                set_dynamic(scene, each.first, each.end);
                is_there = true;
            }
        if (!is_there)
            throw scene_error(fmt::format("{}: no triangle is of a node or group named '{}'; {}", label,
                                          shown(name), names_in(scene)));
    }
    return scene;
}

bool is_transparent(const mesh& scene) {
    return std::ranges::any_of(scene.material_ids,
                               [&](std::uint32_t id) { return scene.materials[id].colour.a < 1; });
}

mesh with_opacity(mesh scene, float opacity) {
    paint(scene, {});
    for (material& each : scene.materials)
        if (each.colour.a == 1)
            each.colour.a = opacity;
    return scene;
}

mesh load_mesh(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    const std::string known =
        known_extension(extension.empty() ? extension : extension.substr(1), path.string());
    std::error_code missing; // which read_file reports
    if (const std::uintmax_t size = std::filesystem::file_size(path, missing);
        !missing && size > most_file_bytes)
        throw scene_error(fmt::format("{}: has {} bytes, and at most {} are read; simplify it", path.string(),
                                      size, most_file_bytes));
    const std::filesystem::path folder = path.parent_path();
    return parse(read_file(path), known, path.string(), &folder);
}

mesh parse_mesh(std::string_view bytes, std::string_view extension, std::string_view name) {
    return parse(bytes, known_extension(extension, name), name, nullptr);
}

}
