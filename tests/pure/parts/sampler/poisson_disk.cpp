// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

static_assert(crease::offers<crease::poisson_disk<>, crease::screen_taps>);
static_assert(!crease::offers<crease::poisson_disk<>, crease::ordered_taps>);

TEST_CASE("poisson_disk has as many taps as its number says") {
    using effect = crease::effect<crease::poisson_disk<9>, crease::single_layer, crease::hbao_plus>;
    CHECK(contains(effect::source<0>(), "const int crease_poisson_disk_count = 9;\n"));
    CHECK(has_part_of(effect::passes[0], "sampler/poisson_disk.glsl"));
}
