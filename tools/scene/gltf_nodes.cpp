// SPDX-License-Identifier: MIT
#include "scene/gltf_nodes.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace crease::tools {
namespace {

using nlohmann::json;

/// The JSON of a file; that of a binary one is its first chunk.
std::string_view json_of(std::string_view file) {
    constexpr std::size_t header = 20; // magic, version, length; length and kind of the chunk
    if (!file.starts_with("glTF") || file.size() < header)
        return file;
    std::uint32_t length = 0;
    std::memcpy(&length, file.data() + 12, sizeof length);
    return file.substr(header, length);
}

/// As many numbers as `count`, or none.
std::vector<double> numbers(const json& of, const char* name, std::size_t count) {
    const auto found = of.find(name);
    if (found == of.end() || !found->is_array() || found->size() != count ||
        !std::ranges::all_of(*found, [](const json& n) { return n.is_number(); }))
        return {};
    return found->get<std::vector<double>>();
}

glm::dmat4 transform_of(const json& node) {
    if (const auto columns = numbers(node, "matrix", 16); !columns.empty())
        return glm::make_mat4(columns.data());
    glm::dmat4 made(1);
    if (const auto t = numbers(node, "translation", 3); !t.empty())
        made = glm::translate(made, {t[0], t[1], t[2]});
    if (const auto r = numbers(node, "rotation", 4); !r.empty())
        made *= glm::mat4_cast(glm::dquat(r[3], r[0], r[1], r[2]));
    if (const auto s = numbers(node, "scale", 3); !s.empty())
        made = glm::scale(made, {s[0], s[1], s[2]});
    return made;
}

/// The indices below `limit` in a list of them.
std::vector<std::size_t> indices(const json& of, const char* name, std::size_t limit) {
    std::vector<std::size_t> all;
    if (const auto found = of.find(name); found != of.end() && found->is_array())
        for (const json& index : *found)
            if (index.is_number_unsigned() && index.get<std::size_t>() < limit)
                all.push_back(index.get<std::size_t>());
    return all;
}

}

gltf_nodes::node gltf_nodes::top() const {
    return roots.size() == 1 ? all[roots.front()] : node{.to_parent = glm::dmat4(1), .children = roots};
}

gltf_nodes read_gltf_nodes(std::string_view file) {
    const json whole = json::parse(json_of(file), nullptr, false);
    gltf_nodes read;
    if (!whole.is_object() || !whole.contains("nodes") || !whole["nodes"].is_array())
        return read;
    const json& nodes = whole["nodes"];
    for (const json& node : nodes)
        read.all.push_back(
            {.to_parent = transform_of(node), .children = indices(node, "children", nodes.size())});
    const auto scenes = whole.find("scenes");
    const auto shown = whole.find("scene");
    const std::size_t scene =
        shown != whole.end() && shown->is_number_unsigned() ? shown->get<std::size_t>() : 0;
    if (scenes != whole.end() && scenes->is_array() && scene < scenes->size())
        read.roots = indices((*scenes)[scene], "nodes", nodes.size());
    return read;
}

}
