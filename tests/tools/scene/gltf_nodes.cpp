// SPDX-License-Identifier: MIT
#include "scene/gltf_nodes.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace crease::tools;

TEST_CASE("glTF nodes: transforms keep all digits of the file") {
    const gltf_nodes read = read_gltf_nodes(
        R"({"scenes": [{"nodes": [1]}, {"nodes": [0, 2]}], "scene": 1, "nodes": [
            {"translation": [6400000.1, 0, -3.3], "children": [2]},
            {"matrix": [2,0,0,0, 0,3,0,0, 0,0,4,0, 6400000.1,5,6,1]},
            {"rotation": [0, 0, 1, 0], "scale": [2, 3, 4], "translation": [1, 2, 3]}]})");
    REQUIRE(read.all.size() == 3);
    CHECK(read.roots == std::vector<std::size_t>{0, 2});
    CHECK(read.all[0].children == std::vector<std::size_t>{2});
    CHECK(read.all[0].to_parent * glm::dvec4(0, 0, 0, 1) == glm::dvec4(6400000.1, 0, -3.3, 1));
    CHECK(read.all[1].to_parent * glm::dvec4(1, 1, 1, 1) == glm::dvec4(6400002.1, 8, 10, 1));
    CHECK(read.all[2].to_parent * glm::dvec4(1, 1, 1, 1) == glm::dvec4(-1, -1, 7, 1)); // half a turn around Z
    CHECK(read.top().children == read.roots);
    CHECK(read.top().to_parent == glm::dmat4(1));
}

TEST_CASE("glTF nodes: one root is the top, and what is no glTF has none") {
    const gltf_nodes one = read_gltf_nodes(
        R"({"scenes": [{"nodes": [1]}], "nodes": [{}, {"translation": [1, 2, 3], "children": [0, 7, -1]}]})");
    CHECK(one.top().to_parent[3] == glm::dvec4(1, 2, 3, 1));
    CHECK(one.top().children == std::vector<std::size_t>{0}); // of those there are
    for (const std::string text :
         {"", "v 0 0 0", "[]", R"({"nodes": 1})", "glTF", R"({"nodes": [{}], "scenes": 3})"})
        CHECK(read_gltf_nodes(text).roots.empty());
}
