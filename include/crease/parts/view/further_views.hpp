// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/view/second_view.hpp>

namespace crease {

struct further_views_part {
    using needs = second_view_part::needs;
    static constexpr number takes[] = {
        {"count", 1, 3, 2, "cameras beside that of the picture"},
        {"divisor", 1, 4, 2, "how much smaller the sides of their pictures are"}};
    static constexpr part description{
        .kind = role::further_views,
        .name = "further_views",
        .summary = "one to three further cameras, for what the first sees at a grazing angle or not at all",
        .source = "stochastic-depth-ao 2020, 7.2, Algorithm 12",
        .files = second_view_part::files,
        .numbers = takes,
        .needs = needs::list,
        .further_views = {.count_number = 0, .divisor = 1},
    };
};

/// `Count` further cameras, whose layers are captured at 1 / `Divisor` of the resolution each way; the host
/// fills as many of `parameters::further_views` at that resolution. See `place_further_camera`.
template <int Count = 2, int Divisor = 2>
struct further_views : further_views_part {
    static constexpr int numbers[] = {Count, Divisor};
};

}
