// crease::effect: the estimator needs taps of areas, which the sampler does not propose
// (mean_height, directions)
// directions/summed_area/mean_height
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, summed_area<>, mean_height<>>::passes.size();
