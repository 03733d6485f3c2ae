// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::offers<crease::poisson_disk<>, crease::screen_taps>);
static_assert(!crease::offers<crease::poisson_disk<>, crease::ordered_taps>);

TEST_CASE("poisson_disk has a point for each tap that it may be asked for") {
    using effect = crease::effect<crease::poisson_disk<64>, crease::single_layer, crease::hbao_plus>;
    CHECK(contains(effect::source<0>, "const int crease_poisson_disk_count = 64;\n"));
    CHECK(crease::poisson_disk_part::takes[0].most == 64);
    CHECK(contains(effect::source<0>, "crease_poisson_disk_points[64]"));
}
