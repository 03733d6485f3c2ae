// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"

#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <glm/geometric.hpp>

#include <cstring>
#include <limits>

using namespace crease::tools;

namespace {

std::string four_bytes(std::uint32_t value) {
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &value, 4); // glTF is little-endian, as is every machine that runs this
    return bytes;
}

struct glb_parts {
    std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3};
    std::string nodes = R"([{"mesh": 0}])", scene_nodes = "[0]";
    int mode = 4; ///< triangles
};

/// A binary glTF file of one mesh.
std::string make_glb(const glb_parts& parts) {
    std::string data(parts.positions.size() * 12 + parts.indices.size() * 4, '\0');
    std::memcpy(data.data(), parts.positions.data(), parts.positions.size() * 12);
    std::memcpy(data.data() + parts.positions.size() * 12, parts.indices.data(), parts.indices.size() * 4);
    const std::string vertices = std::to_string(parts.positions.size()),
                      count = std::to_string(parts.indices.size());
    const std::string split = std::to_string(parts.positions.size() * 12);
    std::string json =
        R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": )" + parts.scene_nodes +
        R"(}], "nodes": )" + parts.nodes +
        R"(, "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": )" +
        std::to_string(parts.mode) + R"(}]}],
           "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": )" +
        vertices + R"(},
                         {"bufferView": 1, "componentType": 5125, "type": "SCALAR", "count": )" +
        count + R"(}],
           "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": )" +
        split + R"(},
                           {"buffer": 0, "byteOffset": )" +
        split + R"(, "byteLength": )" + std::to_string(parts.indices.size() * 4) + R"(}],
           "buffers": [{"byteLength": )" +
        std::to_string(data.size()) + "}]}";
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::size_t size = 12 + 8 + json.size() + 8 + data.size();
    const auto length = [](std::size_t n) { return four_bytes(static_cast<std::uint32_t>(n)); };
    return "glTF" + four_bytes(2) + length(size) + length(json.size()) + "JSON" + json + length(data.size()) +
           std::string("BIN\0", 4) + data;
}

mesh parse(const glb_parts& parts) {
    return parse_mesh(make_glb(parts), "glb", "memory");
}

/// The corners in the order of the triangles.
std::vector<glm::dvec3> corners(const mesh& scene) {
    std::vector<glm::dvec3> result;
    for (const std::uint32_t i : scene.indices)
        result.push_back(scene.positions[i]);
    return result;
}

}

TEST_CASE("mesh: a glb, from memory and from a file") {
    const std::vector<glm::dvec3> expected{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    CHECK(corners(parse({})) == expected);
    const temporary_folder folder;
    CHECK(corners(load_mesh(folder.put("a.glb", make_glb({})))) == expected);
}

TEST_CASE("mesh: node transforms multiply up to the root, and a mesh may stand twice") {
    glb_parts parts;
    parts.indices = {0, 1, 2};
    parts.nodes = R"([{"children": [1, 2], "translation": [10, 0, 0]}, {"mesh": 0, "scale": [2, 3, 4]},
                      {"mesh": 0, "rotation": [0, 0, 1, 0]}])"; // half a turn around Z
    const std::vector<glm::dvec3> expected{{10, 0, 0}, {12, 0, 0}, {10, 3, 0},
                                           {10, 0, 0}, {9, 0, 0},  {10, -1, 0}};
    const std::vector<glm::dvec3> found = corners(parse(parts));
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        CHECK(glm::distance(found[i], expected[i]) <= 4e-15);
}

TEST_CASE("mesh: nodes far from the origin keep the places that the file gives them") {
    glb_parts parts;
    parts.indices = {0, 1, 2};
    parts.scene_nodes = "[0, 1]";
    parts.nodes = R"([{"children": [2], "translation": [6400000.1, 0, -100000.3]},
                      {"mesh": 0, "translation": [6400000.2, 0, 0]}, {"mesh": 0, "translation": [0.0625, 0, 0.25]}])";
    const double x = 6400000.1 + 0.0625, z = -100000.3 + 0.25;
    const std::vector<glm::dvec3> expected{{x, 0, z},         {x + 1, 0, z},         {x, 1, z},
                                           {6400000.2, 0, 0}, {6400000.2 + 1, 0, 0}, {6400000.2, 1, 0}};
    const std::vector<glm::dvec3> found = corners(parse(parts));
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        CHECK(glm::distance(found[i], expected[i]) <= 2e-9); // two roundings at 6.4e6
}

TEST_CASE("mesh: an obj, its polygons in triangles") {
    const temporary_folder folder;
    const mesh square =
        load_mesh(folder.put("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nmtllib absent.mtl\nf 1 2 3 4\n"));
    CHECK(square.triangles() == 2);
    double area = 0;
    const std::vector<glm::dvec3> c = corners(square);
    for (std::size_t i = 0; i < c.size(); i += 3)
        area += glm::length(glm::cross(c[i + 1] - c[i], c[i + 2] - c[i])) / 2;
    CHECK(area == 1);
}

TEST_CASE("mesh: triangles without area are left out") {
    glb_parts parts;
    parts.positions.push_back({2, 0, 0});
    parts.indices = {0, 0, 1, 0, 1, 2, 0, 1, 4};
    CHECK(parse(parts).triangles() == 1);
    parts.indices = {0, 0, 1};
    expect_error<scene_error>("memory: has no triangles", [&] { parse(parts); });
}

TEST_CASE("mesh: broken scenes") {
    glb_parts parts;
    parts.mode = 1; // lines
    expect_error<scene_error>("memory: has no triangles", [&] { parse(parts); });
    parts = {};
    parts.indices[4] = 4;
    expect_error<scene_error>("memory: a triangle uses a vertex that its mesh does not have",
                              [&] { parse(parts); });
    for (const float value :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        parts = {};
        parts.positions[2].y = value;
        expect_error<scene_error>("the position of vertex 2 is not finite", [&] { parse(parts); });
    }
    parts = {};
    parts.nodes =
        R"([{"mesh": 0, "scale": [9e29, 9e29, 9e29], "children": [1]}, {"mesh": 0, "scale": [9, 9, 9]}])";
    expect_error<scene_error>(
        "memory: the position of vertex 5 is not finite, or beyond 1e+30; export it again",
        [&] { parse(parts); });
    const std::string whole = make_glb({});
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{4}, std::size_t{19}, std::size_t{60}, whole.size() - 20}) {
        CAPTURE(size);
        expect_error<scene_error>("memory: broken or unsupported scene",
                                  [&] { parse_mesh(whole.substr(0, size), "glb", "memory"); });
    }
    expect_error<scene_error>("memory: ", [] { parse_mesh("v 0 0 0\nf 1 2 3\n", "obj", "memory"); });
}

TEST_CASE("mesh: what is no scene file") {
    const temporary_folder folder;
    expect_error<scene_error>("absent.glb: no such file", [&] { load_mesh(folder / "absent.glb"); });
    expect_error<scene_error>("cannot read '.fbx' scenes; use .glb, .gltf or .obj",
                              [] { load_mesh("a.fbx"); });
    expect_error<scene_error>("cannot read '.' scenes", [] { load_mesh("a"); });
    expect_error<scene_error>("broken or unsupported scene",
                              [&] { load_mesh(folder.put("a.glb", "not glTF")); });
}

TEST_CASE("mesh: another format under a known extension is not read") {
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    expect_error<scene_error>("broken or unsupported scene", [&] { parse_mesh(ply, "glb", "memory"); });
    expect_error<scene_error>("", [&] { parse_mesh(ply, "obj", "memory"); });
}

TEST_CASE("mesh: the check of one made by hand") {
    const mesh good{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}};
    CHECK_NOTHROW(check_mesh(good, "it"));
    mesh bad = good;
    bad.indices[1] = 3;
    expect_error<scene_error>("it: a triangle uses vertex 3 of a mesh that has 3",
                              [&] { check_mesh(bad, "it"); });
    bad = good;
    bad.indices.push_back(0);
    expect_error<scene_error>("it: has 4 indices", [&] { check_mesh(bad, "it"); });
    expect_error<scene_error>("it: has no triangles", [] { check_mesh({}, "it"); });
}
