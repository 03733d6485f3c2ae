// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/parameters.hpp>

#include <cmath>

namespace crease {

/// Places the second camera of an effect as stochastic-depth-ao 8.3 does: to the right and in front of the
/// first, turned to the middle of what that sees. Fills `further_views[0].from_first`, which is also how a
/// host draws for the second camera: its view matrix is `further_views[0].from_first` times that of the
/// first.
/// @param right,forward  of the first camera, view-space units
/// @param focus          depth of the point in the middle of the first camera's picture that both look at, >
/// forward
inline void place_second_camera(parameters& p, float right, float forward, float focus) {
    const float length = std::sqrt(right * right + (focus - forward) * (focus - forward));
    const float c = (focus - forward) / length, s = right / length; // of the turn to the left
    // The rows are the second camera's axes in the space of the first; then its eye goes to the origin.
    const float rows[3][3] = {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
    const float eye[3] = {right, 0, -forward};
    for (int row = 0; row < 3; ++row) {
        float offset = 0;
        for (int column = 0; column < 3; ++column) {
            p.further_views[0].from_first[4 * column + row] = rows[row][column];
            offset -= rows[row][column] * eye[column];
        }
        p.further_views[0].from_first[12 + row] = offset;
        p.further_views[0].from_first[4 * row + 3] = 0;
    }
    p.further_views[0].from_first[15] = 1;
}

}
