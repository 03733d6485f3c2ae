// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::offers<crease::sphere_points<>, crease::point_taps>);
static_assert(!crease::offers<crease::sphere_points<>, crease::screen_taps>);

TEST_CASE("sphere_points brings the tap with a point") {
    using effect = crease::effect<crease::sphere_points<17>, crease::single_layer, crease::point_volume>;
    CHECK(contains(effect::source<0>(), "const int crease_sphere_points_count = 17;\n"));
    CHECK(has_part_of(effect::passes[0], "sampler/point_tap.glsl"));
}
