// crease::effect: the output needs taps along known directions, which the sampler does not propose
// (bent_cone, poisson_disk)
// poisson_disk/single_layer/hbao_plus/bent_cone
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<poisson_disk<>, single_layer, hbao_plus, bent_cone>::passes.size();
