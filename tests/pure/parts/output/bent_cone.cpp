// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

using bent = effect<directions<4, 4>, single_layer, hbao, bilateral<>, bent_cone>;
static_assert(bent::resources.back().name == "bent_cone");
static_assert(bent::resources.back().texels == format::rgba16_float);
static_assert(bent::resources[bent::resources.size() - 2].name == "visibility");
static_assert(recipe("directions/single_layer/hbao/bent_cone"));
static_assert(!recipe("sphere_lines/single_layer/line_volume/bent_cone")); // knows no open directions
static_assert(!recipe("directions/single_layer/hbao/bent_cone/shade"));

}

TEST_CASE("bent_cone leaves with visibility, and is kept whole between passes") {
    CHECK(contains(bent::source<0>(), "crease_turned_normal(receiver, direction, cosine, sine)"));
    CHECK(contains(bent::source<0>(), "vec3(0.0, 0.0, 1.0), 1.57079633)")); // background is open all around
    CHECK(
        contains(bent::source<2>(), "imageStore(crease_bent_cone, pixel, crease_encode_bent_cone(result));"));
    const auto r = std::ranges::find(bent::resources, "between_0", &resource::name);
    REQUIRE(r != bent::resources.end());
    CHECK(r->texels == format::rg32_uint);
}
