// SPDX-License-Identifier: MIT
#include "tune/chart.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace crease::tools;

namespace {

std::ptrdiff_t occurrences(const std::string& of, const std::string& in) {
    std::ptrdiff_t count = 0;
    for (std::size_t at = in.find(of); at != std::string::npos; at = in.find(of, at + 1))
        ++count;
    return count;
}

}

TEST_CASE("a chart is an SVG that is whole, and grows by a line for each point of the front") {
    const chart_point points[] = {
        {100, 0.09, ""}, {100, 0.09, "cheap"}, {400, 0.05, "dear"}, {300, 0.08, ""}};
    const std::string all = front_chart(points, "cost", "error");
    CHECK(all.starts_with("<?xml"));
    CHECK(all.find("<svg") != std::string::npos);
    CHECK(all.ends_with("</svg>\n"));
    const std::string few = front_chart({points, 2}, "cost", "error");
    CHECK(occurrences("<path", all) > occurrences("<path", few));
}

TEST_CASE("a chart of one point has axes of a width") {
    const chart_point point[] = {{100, 0.09, "only"}};
    const std::string all = front_chart(point, "cost", "error");
    CHECK(all.find("nan") == std::string::npos);
    CHECK(all.find("inf") == std::string::npos);
}
