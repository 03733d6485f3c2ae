// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <cmath>

TEST_CASE("the angle of a horizon by a polynomial is at most 0.0006 off") {
    CHECK(contains(crease::open_horizon_glsl.text,
                   "sine * (1.570207 + cosine * (-0.974326 + cosine * (0.605502 - cosine * 0.205034)))"));
    for (int i = 0; i <= 1000; ++i) {
        const double angle = 1.5707963267948966 * i / 1000, c = std::cos(angle);
        const double found = std::sin(angle) * (1.570207 + c * (-0.974326 + c * (0.605502 - c * 0.205034)));
        CHECK(std::abs(found - angle) <= 0.0006);
    }
}

TEST_CASE("what horizons leave open stands only where an output asks for it") {
    using namespace crease;
    using plain = effect<directions<4, 4>, single_layer, hbao>;
    using bent = effect<directions<4, 4>, single_layer, hbao, bent_cone>;
    CHECK_FALSE(contains(plain::source<0>(), "crease_horizon_angle"));
    CHECK(contains(bent::source<0>(), "crease_horizon_angle"));
}
