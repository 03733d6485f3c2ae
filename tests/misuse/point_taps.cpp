// crease::effect: the estimator needs taps at points in space, which the sampler does not propose
// (ssao, directions)
// directions/single_layer/ssao
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, ssao>::passes.size();
