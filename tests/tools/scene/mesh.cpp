// SPDX-License-Identifier: MIT
#include "image/file.hpp"
#include "scene/scene.hpp"

#include "expect_error.hpp"
#include "gltf_file.hpp"
#include "temporary_folder.hpp"

#include <limits>

using namespace crease::tools;

namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

}

TEST_CASE("mesh: a glb and an obj, from memory and from files of any case") {
    const temporary_folder folder;
    for (const std::string extension : {"glb", "gltf", "GLB", "GlTF"}) {
        CHECK(parse_mesh(gltf_file().glb(), extension, "memory").triangles() == 2);
        CHECK(load_mesh(folder.put("a." + extension, gltf_file().glb())).triangles() == 2);
    }
    for (const std::string extension : {"obj", "OBJ"}) {
        CHECK(parse_mesh(triangle, extension, "memory").triangles() == 1);
        CHECK(load_mesh(folder.put("a." + extension, triangle)).triangles() == 1);
    }
}

TEST_CASE("mesh: a gltf with its data in a file beside it") {
    const temporary_folder folder;
    gltf_file file;
    file.json["buffers"][0]["uri"] = "my%20data.bin";
    folder.put("my data.bin", file.data);
    CHECK(load_mesh(folder.put("a.gltf", file.json.dump())).triangles() == 2);
    expect_error<scene_error>("memory: buffers[0].uri is the file 'my%20data.bin'",
                              [&] { parse_mesh(file.json.dump(), "gltf", "memory"); });
}

TEST_CASE("mesh: an obj's materials that cannot be read change nothing") {
    const temporary_folder folder;
    folder.put("a.mtl", std::string("newmtl a\naniso 0.7\nmt\0,\xff map_Kd\n", 32));
    CHECK(load_mesh(folder.put("a.obj", "mtllib a.mtl\nusemtl a\n" + triangle)).triangles() == 1);
}

TEST_CASE("mesh: an obj's materials are beside it") {
    const temporary_folder folder;
    folder.put("clear glass.mtl", "newmtl a\nd 0.5\n");
    const std::string scene = "mtllib clear glass.mtl\nusemtl a\n" + triangle;
    CHECK(is_transparent(load_mesh(folder.put("a.obj", scene))));
    CHECK_FALSE(is_transparent(parse_mesh(scene, "obj", "memory"))); // which reads no further file
    folder.put("clear glass.mtl", "newmtl a\nd 1.5\n");
    expect_error<scene_error>("a.obj: needs 'clear glass.mtl': line 2: '1.5' is not a number from 0 to 1",
                              [&] { load_mesh(folder / "a.obj"); });
    std::filesystem::resize_file(folder / "clear glass.mtl", (1u << 24) + 1);
    expect_error<scene_error>(
        "a.obj: needs 'clear glass.mtl', which has more than 16777216 bytes; simplify it",
        [&] { load_mesh(folder / "a.obj"); });
}

TEST_CASE("mesh: paint is for the triangles that have none yet") {
    mesh scene{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .indices = {0, 1, 2}};
    const material red{{1, 0, 0, 0.5f}}, blue{{0, 0, 1, 1}};
    CHECK_FALSE(is_transparent(scene));
    CHECK(scene.material_of(0) == material{});
    paint(scene, red);
    paint(scene, blue); // of none
    add_triangle(scene, 2, 1, 0);
    CHECK(scene.material_of(1) == material{});
    paint(scene, blue);
    add_triangle(scene, 0, 1, 2);
    paint(scene, blue);
    CHECK(scene.material_of(0) == red);
    CHECK(scene.material_of(1) == blue);
    CHECK(scene.material_of(2) == blue);
    CHECK(scene.materials.size() == 2);
    CHECK(is_transparent(scene));
    const mesh clear = with_opacity(scene, 0.25f);
    CHECK(clear.material_of(0) == red);
    CHECK(clear.material_of(1) == material{{0, 0, 1, 0.25f}});
    scene.materials.clear();
    scene.material_ids.clear();
    CHECK(with_opacity(scene, 0.25f).material_of(2) == material{{1, 1, 1, 0.25f}});
}

TEST_CASE("mesh: triangles are dynamic by the names that the scene has, and no others are looked for") {
    mesh scene;
    scene.named = {{"a", 0, 2}, {"b", 2, 3}, {"a", 4, 5}};
    scene.dynamic = {false, false, false, true};
    using flags = std::vector<bool>;
    CHECK(with_dynamic(scene, {}, "s").dynamic == scene.dynamic);
    const std::string names[] = {"b", "a"};
    CHECK(with_dynamic(scene, std::span(names, 1), "s").dynamic == flags{false, false, true, true});
    CHECK(with_dynamic(scene, names, "s").dynamic == flags{true, true, true, true, true});
    const std::string wrong[] = {"b", "c\n"};
    expect_error<scene_error>("s: no triangle is of a node or group named 'c?'; there are 'a', 'b'",
                              [&] { with_dynamic(scene, wrong, "s"); });
    for (int i = 0; i < 30; ++i)
        scene.named.push_back({"n" + std::to_string(i), 0, 1});
    expect_error<scene_error>("'n23', 'n24' and 12 more", [&] { with_dynamic(scene, wrong, "s"); });
    expect_error<scene_error>("s: no triangle is of a node or group named 'b'; the scene names none",
                              [&] { with_dynamic({}, names, "s"); });
}

TEST_CASE("mesh: triangles without area are left out") {
    gltf_file file;
    file.primitive()["indices"] = file.add<std::uint8_t>(gltf_uint8, "SCALAR", {0, 0, 1, 0, 1, 2});
    CHECK(parse_mesh(file.glb(), "glb", "memory").triangles() == 1);
    file.primitive()["indices"] = file.add<std::uint8_t>(gltf_uint8, "SCALAR", {0, 0, 1});
    expect_error<scene_error>("memory: has no triangles", [&] { parse_mesh(file.glb(), "glb", "memory"); });
}

TEST_CASE("mesh: positions that are not finite, or too far") {
    for (const float value :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e31f}) {
        gltf_file file;
        file.primitive()["attributes"]["POSITION"] =
            file.add<float>(gltf_float, "VEC3", {0, 0, 0, 1, 0, 0, 0, value, 0, 0, 0, 1});
        expect_error<scene_error>(
            "memory: the position of vertex 2 is not finite, or beyond 1e+30; export it again",
            [&] { parse_mesh(file.glb(), "glb", "memory"); });
    }
    expect_error<scene_error>("memory: the position of vertex 0 is not finite",
                              [] { parse_mesh("v 0 1e999 0\n" + triangle, "obj", "memory"); });
}

TEST_CASE("mesh: what ends early says what is wrong and in which file") {
    const std::string whole = gltf_file().glb();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        CAPTURE(size);
        expect_error<scene_error>(
            "memory: ", [&] { parse_mesh(std::string_view(whole).substr(0, size), "glb", "memory"); });
    }
    expect_error<scene_error>("memory: line 2: '2' is not one of the 1 vertices",
                              [] { parse_mesh("v 0 0 0\nf 1 2 3\n", "obj", "memory"); });
}

TEST_CASE("mesh: what is no scene file") {
    const temporary_folder folder;
    expect_error<file_error>("absent.glb: no such file", [&] { load_mesh(folder / "absent.glb"); });
    std::filesystem::create_directory(folder / "folder.obj");
    expect_error<file_error>("folder.obj: not a regular file", [&] { load_mesh(folder / "folder.obj"); });
    expect_error<scene_error>("a.fbx: cannot read '.fbx' scenes; use .glb, .gltf or .obj",
                              [] { load_mesh("a.fbx"); });
    expect_error<scene_error>("cannot read '.' scenes", [] { load_mesh("a"); });
    expect_error<scene_error>("a.glb: is broken: its JSON cannot be read at byte 2",
                              [&] { load_mesh(folder.put("a.glb", "not glTF")); });
    const std::filesystem::path large = folder.put("large.obj", "");
    std::filesystem::resize_file(large, (std::uintmax_t{1} << 30) + 1); // takes no room on the disk
    expect_error<scene_error>("large.obj: has 1073741825 bytes, and at most 1073741824 are read",
                              [&] { load_mesh(large); });
}

TEST_CASE("mesh: another format under a known extension is not read") {
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    expect_error<scene_error>("memory: is broken", [&] { parse_mesh(ply, "glb", "memory"); });
    expect_error<scene_error>("memory: has no triangles", [&] { parse_mesh(ply, "obj", "memory"); });
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
    bad = good;
    for (const float wrong : {-0.1f, 1.1f, std::numeric_limits<float>::quiet_NaN()}) {
        bad.materials = {{{1, 1, 1, wrong}}};
        expect_error<scene_error>(
            "it: a material's colour has a number that is not from 0 to 1; export it again",
            [&] { check_mesh(bad, "it"); });
    }
    bad = good;
    bad.material_ids = {0};
    expect_error<scene_error>("it: a triangle is of a material that is not there",
                              [&] { check_mesh(bad, "it"); });
}
