// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

struct visibility {
    double hard, linear, quad;
};

/// Of a point on the floor before an endless wall. Seen from above, cosine-weighted directions are uniform in
/// the unit disk, and the wall at distance s * radius is met within the radius where the disk's X >= s.
inline visibility before_wall(double s) {
    if (s >= 1)
        return {1, 1, 1};
    const double q = std::sqrt(1 - s * s), angle = std::acos(s), pi = std::numbers::pi;
    const double hard = (angle - s * q) / pi;
    return {1 - hard, 1 - hard + 2 * s / pi * (std::atanh(q) - q),
            1 - hard + 2 * s * s / pi * (q / s - angle)};
}
