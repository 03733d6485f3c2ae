// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

static_assert(crease::offers<crease::sample_box, crease::area_taps>);
static_assert(!crease::offers<crease::sample_box, crease::screen_taps>);

TEST_CASE("sample_box proposes areas, which single layers refuse") {
    CHECK(crease::recipe("sample_box/summed_area/mean_height"));
    CHECK(crease::recipe("sample_box/single_layer/hbao_plus").error() ==
          "crease::effect: the sampler proposes areas, and the depth source holds no means over them "
          "(sample_box, single_layer)");
}
