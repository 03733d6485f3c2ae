// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

namespace crease::tools {

/// A point of a chart.
struct chart_point {
    double x = 0, y = 0; ///< x > 0
    std::string name;    ///< of a point of the front; else empty
};

/// A front of cost against error as an SVG: all points, those with a name joined and listed below.
/// @param x,y  what the axes say; the first is logarithmic
std::string front_chart(std::span<const chart_point> points, const std::string& x, const std::string& y);

}
