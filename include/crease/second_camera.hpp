// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/parameters.hpp>

#include <cmath>

namespace crease {

/// Places a further camera as stochastic-depth-ao 8.3 does its second: beside and in front of the first,
/// turned to the middle of what that sees. Fills `from_first`, which is also how a host draws for it: its
/// view matrix is `from_first` times that of the first.
/// @param right,forward  of the first camera, view-space units; to the left where `right` is negative
/// @param focus          depth of the point in the middle of the first camera's picture that both look at, >
/// forward
inline void place_further_camera(further_view& camera, float right, float forward, float focus) {
    const float length = std::sqrt(right * right + (focus - forward) * (focus - forward));
    const float c = (focus - forward) / length, s = right / length; // of the turn to the left
    // The rows are the camera's axes in the space of the first; then its eye goes to the origin.
    const float rows[3][3] = {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
    const float eye[3] = {right, 0, -forward};
    for (int row = 0; row < 3; ++row) {
        float offset = 0;
        for (int column = 0; column < 3; ++column) {
            camera.from_first[4 * column + row] = rows[row][column];
            offset -= rows[row][column] * eye[column];
        }
        camera.from_first[12 + row] = offset;
        camera.from_first[4 * row + 3] = 0;
    }
    camera.from_first[15] = 1;
}

/// The same of the second camera, `further_views[0]`.
inline void place_second_camera(parameters& p, float right, float forward, float focus) {
    place_further_camera(p.further_views[0], right, forward, focus);
}

}
