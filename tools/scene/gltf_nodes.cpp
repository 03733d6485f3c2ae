// SPDX-License-Identifier: MIT
#include "scene/gltf_nodes.hpp"

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>

namespace crease::tools {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

glm::dvec3 vector(const gltf_value& node, const char* member, const glm::dvec3& otherwise) {
    return node.has(member) ? glm::make_vec3(node[member].numbers(3).data()) : otherwise;
}

glm::dquat rotation_of(const gltf_value& node) {
    if (!node.has("rotation"))
        return {1, 0, 0, 0};
    const std::vector<double> r = node["rotation"].numbers(4);
    const glm::dquat rotation(r[3], r[0], r[1], r[2]);
    const double length = glm::length(rotation);
    if (!(length > 0 && std::isfinite(length)))
        node["rotation"].fail("must be a unit quaternion");
    return rotation / length;
}

glm::dmat4 to_parent(const gltf_value& node) {
    if (node.has("matrix"))
        return glm::make_mat4(node["matrix"].numbers(16).data());
    return transform(vector(node, "translation", glm::dvec3(0)), rotation_of(node),
                     vector(node, "scale", glm::dvec3(1)));
}

struct forest {
    std::vector<std::vector<std::size_t>> children;
    std::vector<std::size_t> parent; ///< `none` for a root
};

forest read_forest(const gltf_value& root, std::size_t count) {
    forest read{std::vector<std::vector<std::size_t>>(count), std::vector<std::size_t>(count, none)};
    for (std::size_t i = 0; i < count; ++i) {
        const gltf_value node = root["nodes"].at(i);
        for (std::size_t k = 0; k < node.count("children"); ++k) {
            const gltf_value reference = node["children"].at(k);
            const std::size_t child = reference.index(count);
            if (read.parent[child] != none)
                reference.fail(
                    fmt::format("is node {}, which is a child already, and nodes form trees", child));
            read.parent[child] = i;
            read.children[i].push_back(child);
        }
    }
    return read;
}

/// Calls `visit` for a node and all below it, each before its children, as deep as they go.
template <typename Visit>
void walk(const forest& nodes, std::size_t from, Visit visit) {
    std::vector<std::size_t> open{from};
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        visit(node);
        open.insert(open.end(), nodes.children[node].rbegin(), nodes.children[node].rend());
    }
}

/// The nodes at the top of the scene that is shown: the one that the file names, else the first, else all
/// there are.
std::vector<std::size_t> top_nodes(const gltf_value& root, const forest& nodes) {
    std::vector<std::size_t> top;
    const std::size_t scenes = root.count("scenes");
    if (scenes == 0) {
        for (std::size_t i = 0; i < nodes.parent.size(); ++i)
            if (nodes.parent[i] == none)
                top.push_back(i);
        return top;
    }
    std::vector<bool> listed(nodes.parent.size());
    const gltf_value scene = root["scenes"].at(root.has("scene") ? root["scene"].index(scenes) : 0);
    for (std::size_t k = 0; k < scene.count("nodes"); ++k) {
        const gltf_value reference = scene["nodes"].at(k);
        const std::size_t node = reference.index(nodes.parent.size());
        if (nodes.parent[node] != none || listed[node])
            reference.fail(
                fmt::format("is node {}, which stands in the scene already or below another node", node));
        listed[node] = true;
        top.push_back(node);
    }
    return top;
}

/// Of animations only that they are there is read.
std::vector<bool> animated_nodes(const gltf_value& root, std::size_t count) {
    std::vector<bool> animated(count);
    for (std::size_t i = 0; i < root.count("animations"); ++i) {
        const gltf_value animation = root["animations"].at(i);
        for (std::size_t k = 0; k < animation.count("channels"); ++k) {
            const gltf_value target = animation["channels"].at(k)["target"];
            if (target.has("node"))
                animated[target["node"].index(count)] = true;
        }
    }
    return animated;
}

}

glm::dmat4 transform(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale) {
    return glm::scale(glm::translate(glm::dmat4(1), translation) * glm::mat4_cast(rotation), scale);
}

gltf_nodes read_gltf_nodes(const gltf_value& root) {
    const std::size_t count = root.count("nodes");
    const forest nodes = read_forest(root, count);
    gltf_nodes placed;
    placed.to_world.resize(count);
    placed.depth.resize(count);
    placed.animated = animated_nodes(root, count);
    std::size_t reached = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (nodes.parent[i] == none)
            walk(nodes, i, [&](std::size_t node) {
                const std::size_t parent = nodes.parent[node];
                const glm::dmat4 own = to_parent(root["nodes"].at(node));
                placed.to_world[node] = parent == none ? own : placed.to_world[parent] * own;
                placed.depth[node] = parent == none ? 0 : placed.depth[parent] + 1;
                ++reached;
            });
    if (reached != count)
        root["nodes"].fail("has a node that stands below itself");
    for (const std::size_t node : top_nodes(root, nodes))
        walk(nodes, node, [&](std::size_t each) { placed.shown.push_back(each); });
    return placed;
}

}
