// crease::effect: the depth source holds means over areas, of which the estimator makes nothing
// (summed_area, nearest_layer)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

// An estimator that takes whatever taps there are, and no means.
struct nearest_layer {
    static constexpr part description{
        .kind = role::estimator, .name = "nearest_layer", .summary = "", .source = ""};
};

constexpr auto count = effect<sample_box, summed_area<>, nearest_layer>::passes.size();
