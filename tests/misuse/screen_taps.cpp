// crease::effect: taps on the screen are needed, which the sampler does not propose
// (hbao_plus, hemisphere_points)
// hemisphere_points/single_layer/hbao_plus
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<hemisphere_points<>, single_layer, hbao_plus>::passes.size();
