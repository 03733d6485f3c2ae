// crease::effect: the sampler proposes areas, and the depth source holds no means over them
// (sample_box, single_layer)
// sample_box/single_layer/mean_height
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<sample_box, single_layer, mean_height<>>::passes.size();
