// SPDX-License-Identifier: MIT
#pragma once

#include <crease/depth/layers.hpp>
#include <crease/fold/all_layers.hpp>

namespace crease {

inline constexpr glsl_file two_views_glsl{
    "view/two_views.glsl",
#include <crease/view/two_views.glsl>
};

/// Works from a position and a normal alone, whichever side the camera sees.
CREASE_TRAIT(any_eye, estimator,
             "the second view needs an estimator that works from any eye, which this one does not");

struct second_view_part {
    using needs = traits<layers_of_two_views, any_eye, any_view>;
    static constexpr number takes[] = {
        {"divisor", 1, 4, 2, "how much smaller the sides of the second camera's picture are"}};
    static constexpr resource captured[] = {{.name = "second_captured_layers"}};
    static constexpr part description{
        .kind = role::second_view,
        .name = "second_view",
        .summary = "a second camera, for what the first sees at a grazing angle",
        .source = "stochastic-depth-ao 2020, 7.2, Algorithm 12",
        .numbers = takes,
        .needs = needs::list,
        .intermediates = captured,
        .main_body = &two_views_glsl,
    };
};

/// A second camera, whose layers are captured at 1 / `Divisor` of the resolution each way; the host fills
/// `parameters::second_view` at that resolution, and `second_from_first`. See `place_second_camera`.
template <int Divisor = 2>
struct second_view : second_view_part {
    static constexpr int numbers[] = {Divisor};
};

}
