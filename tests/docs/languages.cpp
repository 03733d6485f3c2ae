// SPDX-License-Identifier: MIT
// The C++ of docs/languages.md gives the numbers that it asks for.
#include <crease/crease.hpp>
#include <crease/translate.hpp>

#include <doctest/doctest.h>

#include "languages.inc"

TEST_CASE("a host asks for registers and for other defaults") {
    using ao = crease::effect<crease::directions<8, 4>, crease::single_layer, crease::hbao>;
    const crease::translate::translation made = languages_page::for_direct3d(ao::view(), ao::passes[0]);
    REQUIRE(made.bindings.size() == 4);
    CHECK(made.bindings[1].name == "depth");
    CHECK(made.bindings[1].number == 4);
    CHECK(made.bindings[1].sampler == 0);
    CHECK(made.bindings[1].space == 1);
    CHECK(made.bindings[2].number == 0);
    CHECK(made.text.find("#define CREASE_DIRECTIONS_STEPS 6\n") != std::string::npos);
}
