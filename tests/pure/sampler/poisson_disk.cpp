// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

static_assert(crease::offers<crease::poisson_disk<>, crease::screen_taps>);
static_assert(!crease::offers<crease::poisson_disk<>, crease::ordered_taps>);

TEST_CASE("the points of poisson_disk keep apart, for every count") {
    for (int count : {2, 5, 16, 64, 256})
        for (double offset : {0.0, 0.5, 0.99}) {
            std::vector<std::complex<double>> points;
            for (int i = 0; i < count; ++i)
                points.push_back(std::polar(std::sqrt((i + offset) / count), 2.39996323 * (i + 1)));
            double least = 9;
            for (std::size_t i = 0; i < points.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    least = std::min(least, std::abs(points[i] - points[j]));
            CAPTURE(count);
            CAPTURE(offset);
            CHECK(least * std::sqrt(count) > 0.99);
        }
}
