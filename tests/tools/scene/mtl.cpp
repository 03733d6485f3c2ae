// SPDX-License-Identifier: MIT
#include "scene/mtl.hpp"

#include "expect_error.hpp"

using namespace crease::tools;

namespace {

material only(const std::string& lines) {
    const mtl_materials read = read_mtl("newmtl a\n" + lines);
    REQUIRE(read.size() == 1);
    return read.at("a");
}

void check_refused(const std::string& lines, const std::string& part) {
    expect_error<scene_error>(part, [&] { read_mtl("newmtl a\n" + lines); });
}

}

TEST_CASE("mtl: diffuse colour and opacity, by name, and every other line is passed over") {
    const mtl_materials read =
        read_mtl("# a comment\nd 0.9\nnewmtl clear glass\nNs 96\nKa 1 1 1\nKd 0.2 0.4 0.6\n"
                 "d 0.25\nillum 2\nmap_Kd a.png\n\nnewmtl b\n");
    REQUIRE(read.size() == 2);
    CHECK(read.at("clear glass") == material{{0.2f, 0.4f, 0.6f, 0.25f}});
    CHECK(read.at("b") == material{});
    CHECK(read_mtl("").empty());
    CHECK(read_mtl(std::string("\0\xff d 7\nKd\n", 11)).empty());
}

TEST_CASE("mtl: the forms of the lines") {
    CHECK(only("Kd .5\n") == material{{0.5f, 0.5f, 0.5f, 1}});
    CHECK(only("Kd .5 .25\n") == material{{0.5f, 0.25f, 0.25f, 1}});
    CHECK(only("Kd spectral a.rfl 1\nKd xyz 1 2 3\n") == material{});
    CHECK(only("d -halo 0.5\n") == material{{1, 1, 1, 0.5f}});
    CHECK(only("Tr 0.25\r\n") == material{{1, 1, 1, 0.75f}});
    CHECK(only("d 0.5\nTr 1\n") == material{{1, 1, 1, 0.5f}}); // as exporters disagree on Tr
    CHECK(only("Tr 1\nd 0.5\n") == material{{1, 1, 1, 0.5f}});
}

TEST_CASE("mtl: what is no share") {
    check_refused("d 1.5\n", "line 2: '1.5' is not a number from 0 to 1; export it again");
    check_refused("Tr -0.1\n", "line 2: '-0.1' is not a number from 0 to 1");
    check_refused("\nd nan\n", "line 3: 'nan' is not a number from 0 to 1");
    check_refused("Kd 0 inf 0\n", "line 2: 'inf' is not a number from 0 to 1");
    check_refused("d x\n", "line 2: 'x' is not a number");
    check_refused("d\n", "line 2: a number from 0 to 1 is missing");
    check_refused("d -halo\n", "line 2: a number from 0 to 1 is missing");
    check_refused("Kd\n", "line 2: a number from 0 to 1 is missing");
}
