// crease::effect: the estimator needs taps at each texel of a window, which the sampler does not propose
// (unsharp_mask, directions)
// directions/single_layer/unsharp_mask
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, unsharp_mask>::passes.size();
