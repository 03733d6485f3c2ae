// SPDX-License-Identifier: MIT
#include "scene/gltf_nodes.hpp"

#include "expect_error.hpp"
#include "scene/scene.hpp"

#include <nlohmann/json.hpp>

#include <string>

using namespace crease::tools;

namespace {

gltf_nodes read(const std::string& json) {
    const nlohmann::json parsed = nlohmann::json::parse(json);
    return read_gltf_nodes(gltf_value(parsed));
}

}

TEST_CASE("glTF nodes: transforms keep all digits of the file") {
    const gltf_nodes nodes = read(
        R"({"scenes": [{"nodes": [1]}, {"nodes": [0]}], "scene": 1, "nodes": [
            {"translation": [6400000.1, 0, -3.3], "children": [2]},
            {"matrix": [2,0,0,0, 0,3,0,0, 0,0,4,0, 6400000.1,5,6,1]},
            {"rotation": [0, 0, 1, 0], "scale": [2, 3, 4], "translation": [1, 2, 3]}]})");
    CHECK(nodes.shown == std::vector<std::size_t>{0, 2});
    REQUIRE(nodes.to_world.size() == 3);
    CHECK(nodes.to_world[0] * glm::dvec4(0, 0, 0, 1) == glm::dvec4(6400000.1, 0, -3.3, 1));
    CHECK(nodes.to_world[1] * glm::dvec4(1, 1, 1, 1) == glm::dvec4(6400002.1, 8, 10, 1));
    CHECK(nodes.to_world[2] * glm::dvec4(1, 1, 1, 1) ==
          glm::dvec4(6400000.1 - 1, -1, -3.3 + 7, 1)); // half a turn
}

TEST_CASE("glTF nodes: the first scene where none is named, every root where there is none, depth first") {
    const std::string nodes = R"("nodes": [{"children": [3, 1]}, {"children": [2]}, {}, {}, {}])";
    CHECK(read(R"({"scenes": [{"nodes": [4, 0]}], )" + nodes + "}").shown ==
          std::vector<std::size_t>{4, 0, 3, 1, 2});
    CHECK(read("{" + nodes + "}").shown == std::vector<std::size_t>{0, 3, 1, 2, 4});
    CHECK(read(R"({"scenes": [{}], )" + nodes + "}").shown.empty());
    CHECK(read("{}").shown.empty());
}

TEST_CASE("glTF nodes: a chain as deep as the file likes") {
    nlohmann::json json;
    constexpr std::size_t depth = 20'000;
    for (std::size_t i = 0; i < depth; ++i)
        json["nodes"].push_back({{"children", {i + 1}}, {"translation", {1, 0, 0}}});
    json["nodes"].push_back(nlohmann::json::object());
    const gltf_nodes nodes = read_gltf_nodes(gltf_value(json));
    CHECK(nodes.shown.size() == depth + 1);
    CHECK(nodes.to_world.back()[3].x == depth);
}

TEST_CASE("glTF nodes: what is no tree") {
    expect_error<scene_error>("nodes[0].children[1] is node 1, which is a child already",
                              [] { read(R"({"nodes": [{"children": [1, 1]}, {}]})"); });
    expect_error<scene_error>("nodes[1].children[0] is node 2, which is a child already",
                              [] { read(R"({"nodes": [{"children": [2]}, {"children": [2]}, {}]})"); });
    expect_error<scene_error>("nodes has a node that stands below itself",
                              [] { read(R"({"nodes": [{"children": [1]}, {"children": [0]}, {}]})"); });
    expect_error<scene_error>("nodes has a node that stands below itself",
                              [] { read(R"({"nodes": [{"children": [0]}]})"); });
    expect_error<scene_error>(
        "scenes[0].nodes[0] is node 1, which stands in the scene already or below another",
        [] { read(R"({"scenes": [{"nodes": [1]}], "nodes": [{"children": [1]}, {}]})"); });
    expect_error<scene_error>("nodes[0].children[0] is 7, and there are only 1",
                              [] { read(R"({"nodes": [{"children": [7]}]})"); });
}
