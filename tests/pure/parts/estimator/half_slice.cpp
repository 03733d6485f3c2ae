// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <cmath>

TEST_CASE("the measure of a half slice is the integral of the cosine lobe") {
    CHECK(contains(crease::half_slice_glsl.text,
                   "0.5 * (normal.x * sine * sine + normal.y * (acos(cosine) - sine * cosine))"));
    for (double a : {0.0, 0.3, 0.9})
        for (double b : {-0.4, 0.0, 0.4})
            for (double end : {0.2, 1.0, 1.5}) {
                double sum = 0;
                for (int i = 0; i < 1000; ++i) {
                    const double t = end * (i + 0.5) / 1000;
                    sum += (a * std::cos(t) + b * std::sin(t)) * std::sin(t) * end / 1000;
                }
                const double sine = std::sin(end);
                CHECK(0.5 * (a * sine * sine + b * (end - sine * std::cos(end))) ==
                      doctest::Approx(sum).epsilon(1e-5));
            }
}
