// crease::effect: the first part must be a sampler
// (single_layer)
// single_layer/single_layer/hbao
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<single_layer, single_layer, hbao>::passes.size();
