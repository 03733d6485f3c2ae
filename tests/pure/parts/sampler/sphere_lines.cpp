// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::offers<crease::sphere_lines<>, crease::line_taps>);
static_assert(!crease::offers<crease::sphere_lines<>, crease::point_taps>);

TEST_CASE("sphere_lines brings the lines of a disk") {
    using effect = crease::effect<crease::sphere_lines<8>, crease::single_layer, crease::line_volume>;
    CHECK(contains(effect::source<0>(), "const int crease_sphere_lines_count = 8;\n"));
    CHECK(has_part_of(effect::passes[0], "sampler/line_tap.glsl"));
    CHECK(has_part_of(effect::passes[0], "sampler/disk_lines.glsl"));
}
