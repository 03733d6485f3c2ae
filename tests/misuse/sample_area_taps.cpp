// crease::effect: the estimator needs the area of the sample box, which the sampler does not propose
// (mean_height, box_area)
// box_area/summed_area/mean_height
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<box_area<>, summed_area<>, mean_height<>>::passes.size();
