// crease::effect: the estimator needs taps at points in space, which the sampler does not propose
// (ssao, half_directions)
// preset:medium/ssao
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<preset::medium, ssao>::passes.size();
