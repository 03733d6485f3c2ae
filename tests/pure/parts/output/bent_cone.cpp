// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using bent = effect<directions<>, single_layer, hbao, bilateral<>, bent_cone>;
static_assert(bent::resources[bent::resources.size() - 2].name == "visibility");
static_assert(bent::resources.back().name == "bent_cone");
static_assert(bent::resources.back().texels == format::rgba16_float);
static_assert(!recipe("poisson_disk/single_layer/hbao_plus/bent_cone"));

}

TEST_CASE("a bent cone leaves beside visibility, and is kept in two words between passes") {
    const binding& between = bent::passes[0].bindings.back();
    CHECK(bent::resources[between.resource].texels == format::rg32_uint);
    CHECK(bent::passes.back().bindings.back().name == "bent_cone");
    CHECK(contains(bent::source<2>, "crease_encode_visibility(result)"));
    CHECK(contains(bent::source<2>, "imageStore(crease_bent_cone, pixel, crease_encode_bent_cone(result));"));
}

TEST_CASE("the open directions are gathered with bent cones, and not without") {
    using plain = effect<directions<>, single_layer, hbao>;
    CHECK(contains(bent::source<0>, "crease_open_direction"));
    CHECK_FALSE(contains(plain::source<0>, "crease_open_direction"));
}
