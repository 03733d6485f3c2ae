// crease::effect: single layers of depth are needed, which the depth source does not hold
// (hbao, mean_depth)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

// A depth source that has the mean of its layers alone.
struct mean_depth {
    static constexpr crease::part description{
        .kind = crease::role::depth_source, .name = "mean_depth", .summary = "", .source = ""};
};

using namespace crease;

constexpr auto count = effect<directions<>, mean_depth, hbao>::passes.size();
