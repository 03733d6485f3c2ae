// crease::effect: the estimator needs means over areas, which the depth source does not hold
// (mean_height, single_layer)
// sample_box/single_layer/mean_height
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<sample_box, single_layer, mean_height<>>::passes.size();
