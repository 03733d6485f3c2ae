// SPDX-License-Identifier: MIT
#include "scene/gltf.hpp"

#include "expect_error.hpp"
#include "gltf_file.hpp"
#include "temporary_folder.hpp"

#include <glm/geometric.hpp>

#include <limits>

using namespace crease::tools;

namespace {

using points = std::vector<glm::dvec3>;

/// The corners in the order of the triangles.
points corners(const gltf_file& file) {
    const mesh scene = read_gltf(file.glb(), nullptr);
    points result;
    for (const std::uint32_t i : scene.indices)
        result.push_back(scene.positions[i]);
    return result;
}

const points corner_of_tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}};

void check_near(const points& found, const points& expected, double tolerance) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        CAPTURE(i);
        CHECK(glm::distance(found[i], expected[i]) <= tolerance);
    }
}

void check_refused(const gltf_file& file, const std::string& part) {
    expect_error<scene_error>(part, [&] { read_gltf(file.glb(), nullptr); });
}

}

TEST_CASE("glTF: triangles of a mesh") {
    CHECK(corners({}) == corner_of_tetrahedron);
}

TEST_CASE("glTF: node transforms multiply up to the root, and a mesh may stand twice") {
    gltf_file file;
    file.json["nodes"] = nlohmann::json::parse(
        R"([{"children": [1, 2], "translation": [10, 0, 0]}, {"mesh": 0, "scale": [2, 3, 4]},
            {"mesh": 0, "rotation": [0, 0, 1, 0]}])"); // half a turn around Z
    check_near(corners(file),
               {{10, 0, 0},
                {12, 0, 0},
                {10, 3, 0},
                {10, 0, 0},
                {10, 3, 0},
                {10, 0, 4},
                {10, 0, 0},
                {9, 0, 0},
                {10, -1, 0},
                {10, 0, 0},
                {10, -1, 0},
                {10, 0, 1}},
               4e-15);
}

TEST_CASE("glTF: a mirrored mesh keeps its front faces") {
    gltf_file file;
    file.json["nodes"] = nlohmann::json::parse(R"([{"mesh": 0, "scale": [-1, 1, 1]}])");
    CHECK(corners(file) == points{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}});
}

TEST_CASE("glTF: nodes far from the origin keep the places that the file gives them") {
    gltf_file file;
    file.primitive()["mode"] = 4;
    file.json["scenes"][0]["nodes"] = {0, 1};
    file.json["nodes"] = nlohmann::json::parse(
        R"([{"children": [2], "translation": [6400000.1, 0, -100000.3]},
            {"mesh": 0, "translation": [6400000.2, 0, 0]}, {"mesh": 0, "translation": [0.0625, 0, 0.25]}])");
    points expected;
    for (const glm::dvec3 place :
         {glm::dvec3(6400000.1 + 0.0625, 0, -100000.3 + 0.25), glm::dvec3(6400000.2, 0, 0)})
        for (const glm::dvec3& corner : corner_of_tetrahedron)
            expected.push_back(place + corner);
    check_near(corners(file), expected, 2e-9); // two roundings at 6.4e6
}

TEST_CASE("glTF: a file without scenes shows every node") {
    gltf_file file;
    file.json.erase("scene");
    file.json.erase("scenes");
    CHECK(corners(file) == corner_of_tetrahedron);
}

TEST_CASE("glTF: strips, fans and vertices without indices") {
    gltf_file file;
    const points tent{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    file.primitive().erase("indices");
    CHECK(corners(file) == points{tent[0], tent[1], tent[2]});
    file.primitive()["mode"] = 5;
    CHECK(corners(file) == points{tent[0], tent[1], tent[2], tent[1], tent[3], tent[2]});
    file.primitive()["mode"] = 6;
    CHECK(corners(file) == points{tent[0], tent[1], tent[2], tent[0], tent[2], tent[3]});
    for (const int lines_or_points : {0, 1, 2, 3}) {
        file.primitive()["mode"] = lines_or_points;
        CHECK(corners(file).empty());
    }
    file.primitive()["mode"] = 7;
    check_refused(file, "meshes[0].primitives[0].mode is 7");
}

TEST_CASE("glTF: quantised positions (KHR_mesh_quantization)") {
    gltf_file file;
    file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    file.json["nodes"][0]["scale"] = {0.001, 0.001, 0.001};
    // Rows of 8 bytes, as vertices are aligned to 4.
    file.primitive()["attributes"]["POSITION"] = file.add<std::int16_t>(
        gltf_int16, "VEC3", {0, 0, 0, 9, 1000, 0, 0, 9, 0, 1000, 0, 9, 0, 0, -1000, 9});
    file.json["accessors"][2]["count"] = 4;
    file.json["bufferViews"][2]["byteStride"] = 8;
    points expected = corner_of_tetrahedron;
    expected[5] = {0, 0, -1};
    check_near(corners(file), expected, 1e-15);
    SUBCASE("normalised") {
        file.json["accessors"][2]["normalized"] = true;
        for (glm::dvec3& p : expected)
            p /= 32767;
        check_near(corners(file), expected, 1e-18);
    }
}

TEST_CASE("glTF: instances (EXT_mesh_gpu_instancing)") {
    gltf_file file;
    file.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    file.json["nodes"][0]["translation"] = {100, 0, 0};
    auto& attributes = file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    attributes["TRANSLATION"] = file.add<float>(gltf_float, "VEC3", {0, 0, 0, 0, 5, 0});
    attributes["SCALE"] = file.add<float>(gltf_float, "VEC3", {1, 1, 1, 2, 2, 2});
    attributes["ROTATION"] = file.add<std::int8_t>(gltf_int8, "VEC4", {0, 0, 0, 127, 0, 0, 127, 0},
                                                   true); // none; half a turn around Z
    points expected;
    for (const glm::dvec3& corner : corner_of_tetrahedron)
        expected.push_back(glm::dvec3(100, 0, 0) + corner);
    for (const glm::dvec3& corner : corner_of_tetrahedron)
        expected.push_back(glm::dvec3(100, 5, 0) + 2.0 * glm::dvec3(-corner.x, -corner.y, corner.z));
    check_near(corners(file), expected, 1e-13);
    file.json["accessors"][3]["count"] = 1;
    check_refused(
        file, "nodes[0].extensions.EXT_mesh_gpu_instancing.attributes.SCALE must have 3 numbers for each");
}

TEST_CASE("glTF: morph targets by the weights of the mesh, or of the node") {
    gltf_file file;
    file.primitive()["targets"] = nlohmann::json::array();
    file.primitive()["targets"][0]["POSITION"] =
        file.add<float>(gltf_float, "VEC3", {0, 8, 0, 0, 8, 0, 0, 8, 0, 0, 8, 0});
    file.primitive()["targets"][1]["NORMAL"] = 0;
    const auto raised = [](double by) {
        points all = corner_of_tetrahedron;
        for (glm::dvec3& p : all)
            p.y += by;
        return all;
    };
    CHECK(corners(file) == raised(0));
    file.json["meshes"][0]["weights"] = {0.5, 1};
    CHECK(corners(file) == raised(4));
    file.json["nodes"][0]["weights"] = {0.25, 1};
    CHECK(corners(file) == raised(2));
    file.json["accessors"][2]["count"] = 3;
    check_refused(file, "meshes[0].primitives[0].targets[0].POSITION has 3 rows, and there are 4 positions");
}

TEST_CASE("glTF: a skin moves vertices with its joints, and the node of the mesh does not") {
    gltf_file file;
    file.json["nodes"] = nlohmann::json::parse(
        R"([{"mesh": 0, "skin": 0, "translation": [1000, 0, 0]}, {"translation": [0, 10, 0], "children": [2]},
            {"translation": [0, 10, 0]}])");
    file.json["scenes"][0]["nodes"] = {0, 1};
    file.json["skins"][0]["joints"] = {1, 2};
    std::vector<float> bind(32);
    for (const std::size_t i : {0u, 5u, 10u, 15u})
        bind[i] = bind[16 + i] = 1;
    bind[16 + 14] = 3; // of the second joint: moves by 3 along Z
    file.json["skins"][0]["inverseBindMatrices"] = file.add<float>(gltf_float, "MAT4", bind);
    auto& attributes = file.primitive()["attributes"];
    attributes["JOINTS_0"] =
        file.add<std::uint8_t>(gltf_uint8, "VEC4", {0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 9, 9, 9});
    attributes["WEIGHTS_0"] =
        file.add<float>(gltf_float, "VEC4", {.5f, .5f, 0, 0, 1, 0, 0, 0, .25f, .25f, 0, 0, 1, 0, 0, 0});
    // Weights that do not sum to 1 count by their share.
    const glm::dvec3 a{0, 15, 1.5}, b{1, 20, 3}, c{0, 16, 1.5}, d{0, 10, 1};
    CHECK(corners(file) == points{a, b, c, a, c, d});
    SUBCASE("without inverse bind matrices") {
        file.json["skins"][0].erase("inverseBindMatrices");
        CHECK(corners(file)[1] == glm::dvec3(1, 20, 0));
    }
    SUBCASE("a joint that is not there") {
        file.json["skins"][0]["joints"] = {1};
        check_refused(file, "meshes[0].primitives[0] uses joint 1 of a skin that has 1");
    }
    SUBCASE("too few matrices") {
        file.json["accessors"][2]["count"] = 1;
        check_refused(file, "skins[0].inverseBindMatrices must have a matrix of floats for each joint");
    }
}

TEST_CASE("glTF: materials of primitives, and what is masked away is not there") {
    gltf_file file;
    nlohmann::json& primitives = file.json["meshes"][0]["primitives"];
    primitives = {primitives[0], primitives[0], primitives[0], primitives[0]};
    for (std::size_t i = 1; i < 4; ++i)
        primitives[i]["material"] = i - 1;
    file.json["materials"] = nlohmann::json::parse(
        R"([{"alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 0.5]}},
            {"alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.4]}},
            {"pbrMetallicRoughness": {"baseColorFactor": [0, 1, 0, 0.5]}}])");
    const mesh read = read_gltf(file.glb(), nullptr);
    REQUIRE(read.triangles() == 6); // two of each
    CHECK(read.material_of(0) == material{});
    CHECK(read.material_of(1) == material{});
    CHECK(read.material_of(2) == material{{1, 0, 0, 0.5f}});
    CHECK(read.material_of(3) == material{{1, 0, 0, 0.5f}});
    CHECK(read.material_of(5) == material{{0, 1, 0, 1}});
    primitives[3]["material"] = 3;
    check_refused(file, "meshes[0].primitives[3].material is 3, and there are only 3");
    primitives[3]["material"] = 1;
    file.json["materials"][1]["alphaMode"] = "GLASS";
    check_refused(file, "materials[1].alphaMode is 'GLASS', and must be OPAQUE, MASK or BLEND");
}

TEST_CASE("glTF: triangles have the names of their nodes and of those above") {
    gltf_file file;
    file.json["nodes"] = nlohmann::json::parse(
        R"([{"name": "car", "children": [1, 3]}, {"name": "wheel", "mesh": 0, "children": [2]}, {"mesh": 0},
            {"name": "wheel", "mesh": 0}, {"name": "road", "mesh": 0}, {"name": "lamp"}])");
    file.json["scenes"][0]["nodes"] = {5, 0, 4};
    const mesh scene = read_gltf(file.glb(), nullptr);
    CHECK(scene.triangles() == 8);
    CHECK(scene.named ==
          std::vector<named_triangles>{{"wheel", 0, 4}, {"wheel", 4, 6}, {"car", 0, 6}, {"road", 6, 8}});
    CHECK(scene.dynamic.empty());
}

TEST_CASE("glTF: what an animation moves is dynamic with all below it, and so is what has a skin") {
    gltf_file file;
    file.json["nodes"] = nlohmann::json::parse(
        R"([{"mesh": 0}, {"children": [2, 3], "mesh": 0}, {"mesh": 0}, {}, {"mesh": 0, "skin": 0, "children": [5]},
            {"mesh": 0}])");
    file.json["skins"] = nlohmann::json::parse(R"([{"joints": [3]}])");
    file.json["scenes"][0]["nodes"] = {0, 1, 4};
    file.json["animations"] = nlohmann::json::parse(
        R"([{"channels": [{"sampler": 0, "target": {"path": "pointer"}},
                          {"sampler": 0, "target": {"node": 1, "path": "rotation"}}], "samplers": []}])");
    const std::vector<bool> expected{false, false, true, true, true, true, true, true};
    CHECK(read_gltf(file.glb(), nullptr).dynamic == expected); // and the last two are not
    file.json["animations"][0]["channels"][1]["target"]["node"] = 6;
    check_refused(file, "animations[0].channels[1].target.node");
}

TEST_CASE("glTF: what a file requires and is not read is refused by name") {
    gltf_file file;
    file.json["extensionsRequired"] = {"KHR_materials_clearcoat", "KHR_texture_transform"};
    CHECK(corners(file) == corner_of_tetrahedron);
    for (const std::string name : {"ACME_secret", "KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
        file.json["extensionsRequired"] = {name};
        check_refused(file, "needs the extension '" + name + "', which is not read; export it without");
    }
    file = {};
    file.json["asset"]["version"] = "1.0";
    check_refused(file, "is glTF of version 1.0; only version 2.0 is read");
    file.json["asset"] = {{"version", "2.0"}, {"minVersion", "2.1"}};
    check_refused(file, "is glTF of version 2.1");
    file.json.erase("asset");
    check_refused(file, "asset is missing");
}

TEST_CASE("glTF: compressed without being required") {
    gltf_file file;
    file.primitive()["extensions"]["KHR_draco_mesh_compression"] = nlohmann::json::object();
    CHECK(corners(file) == corner_of_tetrahedron); // the same data stands in the file as it is
    file.json["accessors"][0].erase("bufferView");
    check_refused(file, "is compressed with KHR_draco_mesh_compression, which is not read");
    file.primitive().erase("extensions");
    check_refused(file, "meshes[0].primitives[0] has positions without data");
}

TEST_CASE("glTF: a vertex that is not there") {
    gltf_file file;
    file.primitive()["indices"] = file.add<std::uint16_t>(gltf_uint16, "SCALAR", {0, 1, 2, 0, 2, 4});
    check_refused(file, "meshes[0].primitives[0] has a triangle of vertex 4, and 4 vertices");
    for (const float wrong : {-1.f, std::numeric_limits<float>::quiet_NaN()}) {
        file.primitive()["indices"] = file.add<float>(gltf_float, "SCALAR", {0, 1, wrong});
        check_refused(file, "meshes[0].primitives[0] has a triangle of vertex");
    }
}

TEST_CASE("glTF: values of a wrong kind") {
    const struct {
        const char *place, *value, *sentence;
    } cases[] = {
        {"/meshes/0/primitives/0/indices", R"("x")",
         "meshes[0].primitives[0].indices must be a whole number"},
        {"/meshes/0/primitives/0/indices", "4294967297", "meshes[0].primitives[0].indices is 4294967297"},
        {"/meshes/0/primitives/0/attributes", "[]", "meshes[0].primitives[0].attributes must be an object"},
        {"/meshes/0/primitives", "{}", "meshes[0].primitives must be a list"},
        {"/meshes/0/weights", R"(["x"])", "meshes[0].weights[0] must be a number"},
        {"/nodes/0/mesh", "1", "nodes[0].mesh is 1, and there are only 1"},
        {"/nodes/0/mesh", "-1", "nodes[0].mesh must be a whole number"},
        {"/nodes/0/skin", "0", "nodes[0].skin is 0, and there are only 0"},
        {"/nodes/0/translation", "[1, 2]", "nodes[0].translation must be a list of 3 numbers"},
        {"/nodes/0/rotation", "[0, 0, 0, 0]", "nodes[0].rotation must be a unit quaternion"},
        {"/accessors/0/type", R"("MAT3")", "accessors[0].type must be"},
        {"/accessors/0/type", R"("VEC2")",
         "meshes[0].primitives[0].attributes.POSITION must have 3 numbers a row"},
        {"/accessors/0/componentType", "5124", "accessors[0].componentType must be"},
        {"/accessors/0/normalized", "1", "accessors[0].normalized must be true or false"},
        {"/scene", "3", "scene is 3, and there are only 1"},
        {"/scenes/0/nodes", "[0, 0]", "scenes[0].nodes[1] is node 0, which stands in the scene already"}};
    for (const auto& c : cases) {
        CAPTURE(c.place);
        gltf_file file;
        file.json[nlohmann::json::json_pointer(c.place)] = nlohmann::json::parse(c.value);
        check_refused(file, c.sentence);
    }
}

TEST_CASE("glTF: small files that ask for much are refused before anything is expanded") {
    gltf_file file;
    SUBCASE("instances") {
        auto& attributes = file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
        attributes["TRANSLATION"] = 2;
        file.json["accessors"].push_back(
            {{"componentType", gltf_float}, {"type", "VEC3"}, {"count", 1u << 30}});
        check_refused(file,
                      "has 4294967296 vertices where all its meshes stand, and at most 16777216 are read");
    }
    SUBCASE("instances of nothing") {
        file.json["meshes"][0]["primitives"].clear();
        file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = 2;
        file.json["accessors"].push_back(
            {{"componentType", gltf_float}, {"type", "VEC3"}, {"count", 1u << 30}});
        check_refused(file, "has 1073741824 steps of instances, morph targets and joints");
    }
    SUBCASE("nodes") {
        file.primitive()["indices"] =
            file.add<std::uint8_t>(gltf_uint8, "SCALAR", std::vector<std::uint8_t>(3'000'000));
        file.json["scenes"][0]["nodes"].clear();
        file.json["nodes"].clear();
        for (int i = 0; i < 20; ++i) {
            file.json["scenes"][0]["nodes"].push_back(i);
            file.json["nodes"].push_back({{"mesh", 0}});
        }
        check_refused(file, "has 20000000 triangles where all its meshes stand");
    }
    SUBCASE("morph targets") {
        for (int i = 0; i < 20'000; ++i) {
            file.primitive()["targets"].push_back({{"POSITION", 0}});
            file.json["meshes"][0]["weights"].push_back(1);
        }
        file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
            file.add<float>(gltf_float, "VEC3", std::vector<float>(3'000));
        check_refused(file, "has 80005000 steps of instances, morph targets and joints");
    }
}
