// crease::effect: the estimator needs taps along lines through a volume, which the sampler does not propose
// (line_volume, hemisphere_points)
// hemisphere_points/single_layer/line_volume
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<hemisphere_points<>, single_layer, line_volume>::passes.size();
