// crease::effect: the estimator needs taps in order along directions, which the sampler does not propose
// (hbao, poisson_disk)
// poisson_disk/single_layer/hbao
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<poisson_disk<>, single_layer, hbao>::passes.size();
