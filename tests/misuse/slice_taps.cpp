// crease::effect: the estimator needs taps in order along half slices, which the sampler does not propose
// (gtao, poisson_disk)
// poisson_disk/single_layer/gtao
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<poisson_disk<>, single_layer, gtao>::passes.size();
