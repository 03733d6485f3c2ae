// crease::effect: an effect has 48 resources, 24 settings and 4 views at the most
// (hbao, four_eyes)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

// Cameras beside that of the picture, one too many.
struct four_eyes {
    static constexpr crease::part description{.kind = crease::role::further_views,
                                              .name = "four_eyes",
                                              .summary = "",
                                              .source = "",
                                              .further_views = {.count = 4}};
};

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, four_eyes>::passes.size();
