// SPDX-License-Identifier: MIT
#include "scene/obj.hpp"

#include "expect_error.hpp"
#include "temporary_folder.hpp"

using namespace crease::tools;

namespace {

const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::vector<std::uint32_t> indices(const std::string& file) {
    return read_obj(file).indices;
}

void check_refused(const std::string& file, const std::string& part) {
    expect_error<scene_error>(part, [&] { read_obj(file); });
}

}

TEST_CASE("obj: vertices and faces, and every other line is passed over") {
    const mesh read = read_obj("# a comment\nmtllib absent.mtl\no Box\ng a b\nusemtl a\ns 1\n" + three +
                               "vn 0 0 1\nvt 0 0\nl 1 2\np 1\nf 1 2 3\n");
    CHECK(read.positions == std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(read.indices == std::vector<std::uint32_t>{0, 1, 2});
}

TEST_CASE("obj: numbers as exporters write them") {
    const mesh read = read_obj("v .5 -.25 +1.\nv 1e3 -2E-2 +.5e+1\nv 6400000.1 0.1 1e-320\nf 1 2 3");
    CHECK(read.positions[0] == glm::dvec3(.5, -.25, 1));
    CHECK(read.positions[1] == glm::dvec3(1000, -.02, 5));
    CHECK(read.positions[2] == glm::dvec3(6400000.1, .1, 1e-320)); // in 64 bits
    for (const std::string number : {"x", "1,5", "0x10", "--1", "1e", "."})
        check_refused("# first\nv 0 " + number + " 0\n", "line 2: '" + number + "' is not a number");
    check_refused("v 1 2\n", "line 1: a vertex needs three numbers");
}

TEST_CASE("obj: weights and colours after the three coordinates") {
    CHECK(read_obj("v 1 2 3 0.5\nv 1 2 3 1 0 0\n").positions ==
          std::vector<glm::dvec3>{{1, 2, 3}, {1, 2, 3}});
    check_refused("v 1 2 3 x\n", "line 1: 'x' is not a number");
}

TEST_CASE("obj: corners of a face") {
    for (const std::string face :
         {"1 2 3", "1/1 2/1 3/1", "1//1 2//1 3//1", "1/1/1 2/9/9 3/1/1", "-3 -2 -1", "1/ 2/ 3/"})
        CHECK(indices(three + "f " + face) == std::vector<std::uint32_t>{0, 1, 2});
    CHECK(indices("f 1 2 3\n" + three) == std::vector<std::uint32_t>{0, 1, 2}); // of vertices below
    CHECK(indices(three + "f -3 -2 -1\nv 9 9 9\n") == std::vector<std::uint32_t>{0, 1, 2}); // of those above
    for (const std::string corner : {"0", "4", "-4", "x", "1x", "1.5", "99999999999999999999", "/1"})
        check_refused(three + "f 1 2 " + corner, "line 4: '" + corner + "' is not one of the 3 vertices");
    check_refused("v 0 0 0\nf -1 -2 -3\nv 1 1 1\n", "line 2: '-2' is not one of the 1 vertices");
}

TEST_CASE("obj: materials of the faces below the line that names them") {
    const temporary_folder folder;
    folder.put("a.mtl", "newmtl red glass\nKd 1 0 0\nd 0.5\nnewmtl green\nKd 0 1 0\n");
    folder.put("b.mtl", "newmtl green\nKd 0 0 1\n");
    const std::filesystem::path place = folder / "";
    const mesh read = read_obj("mtllib a.mtl\nmtllib b.mtl\nmtllib absent.mtl\nmtllib .\nmtllib\n" + three +
                                   "f 1 2 3\nusemtl red glass\nf 1 2 3\nf 3 2 1\nusemtl green\nf 1 2 3\n"
                                   "usemtl absent\nf 1 2 3\n",
                               &place);
    REQUIRE(read.triangles() == 5);
    CHECK(read.material_of(0) == material{});
    CHECK(read.material_of(1) == material{{1, 0, 0, 0.5f}});
    CHECK(read.material_of(2) == material{{1, 0, 0, 0.5f}});
    CHECK(read.material_of(3) == material{{0, 1, 0, 1}});
    CHECK(read.material_of(4) == material{});
}

TEST_CASE("obj: triangles have the names of their object and of their groups") {
    const mesh read = read_obj(three + "f 1 2 3\no house\ng door wall\nf 1 2 3\nf 1 2 3\ng\nf 1 2 3\no car\n"
                                       "g wall\ng empty\ng wall\nf 1 2 3\n");
    CHECK(read.triangles() == 5);
    CHECK(read.named == std::vector<named_triangles>{
                            {"door", 1, 3}, {"wall", 1, 3}, {"house", 1, 4}, {"car", 4, 5}, {"wall", 4, 5}});
    CHECK(read.dynamic.empty());
}

TEST_CASE("obj: faces of fewer corners, or without area, add nothing") {
    CHECK(indices(three + "f\nf 1\nf 1 2\nf 1 1 2\n").empty());
}

TEST_CASE("obj: ends of lines, blanks and a byte order mark") {
    for (const std::string& file : {std::string("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n"),
                                    std::string("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3"),
                                    std::string("\xef\xbb\xbfv 0 0 0\n\tv  1\t0 0 \n\n v 0 1 0\nf 1 2 3 "),
                                    std::string("v 0 0 0\nv 1 \\\n0 0\nv 0 1 0\nf 1 \\\r\n2 3\n")})
        CHECK(indices(file) == std::vector<std::uint32_t>{0, 1, 2});
    CHECK(indices("").empty());
    check_refused("v 0 \\\n0 \\\n0\nv x\n", "line 4: 'x' is not a number");
}

TEST_CASE("obj: what is shown of a file is short") {
    check_refused("v " + std::string(1'000'000, 'x'),
                  "line 1: '" + std::string(60, 'x') + "...' is not a number");
}
