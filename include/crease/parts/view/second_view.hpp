// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/depth/layers.hpp>
#include <crease/parts/traversal/all_layers.hpp>

namespace crease {

inline constexpr glsl_file further_view_glsl{
    "view/further_view.glsl",
#include <crease/view/further_view.glsl>
};

/// Works from a position and a normal alone, also where the camera sees the back of the surface.
CREASE_TRAIT(any_eye, estimator,
             "the second view needs an estimator that works from any eye, which this one does not");

struct second_view_part {
    using needs = traits<layers_of_two_views, any_eye, any_view>;
    static constexpr number takes[] = {
        {"divisor", 1, 4, 2, "how much smaller the sides of the second camera's picture are"}};
    static constexpr const glsl_file* files[] = {&further_view_glsl};
    static constexpr part description{
        .kind = role::further_views,
        .name = "second_view",
        .summary = "a second camera, for what the first sees at a grazing angle",
        .source = "stochastic-depth-ao 2020, 7.2, Algorithm 12",
        .files = files,
        .numbers = takes,
        .needs = needs::list,
        .further_views = {.count = 1, .divisor = 0},
    };
};

/// A second camera, whose layers are captured at 1 / `Divisor` of the resolution each way; the host fills
/// `parameters::further_views[0]` at that resolution. See `place_second_camera`.
template <int Divisor = 2>
struct second_view : second_view_part {
    static constexpr int numbers[] = {Divisor};
};

}
