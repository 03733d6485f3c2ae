// SPDX-License-Identifier: MIT
#include "scene/obj_lines.hpp"

#include "expect_error.hpp"
#include "scene/scene.hpp"

using namespace crease::tools;

TEST_CASE("obj lines: words, and what is left of a line") {
    obj_lines line("usemtl  a b \t\r\n\nlast");
    REQUIRE(line.next());
    CHECK(line.word() == "usemtl");
    CHECK(line.rest() == "a b");
    CHECK(line.word() == "a");
    CHECK(line.word() == "b");
    CHECK(line.rest().empty());
    CHECK(line.word().empty());
    REQUIRE(line.next());
    CHECK(line.word().empty());
    CHECK(line.rest().empty());
    REQUIRE(line.next());
    CHECK(line.word() == "last");
    expect_error<scene_error>("line 3: it is wrong; export it again", [&] { line.fail("it is wrong"); });
    CHECK_FALSE(line.next());
}

TEST_CASE("obj lines: numbers") {
    obj_lines line("x");
    line.next();
    CHECK(number_of(line, "+1.5", "") == 1.5);
    CHECK(number_of(line, "1e999", "") > 1e300);
    expect_error<scene_error>("line 1: 'x' is not a number", [&] { number_of(line, line.word(), ""); });
    expect_error<scene_error>("line 1: it is missing",
                              [&] { number_of(line, line.word(), "it is missing"); });
}
