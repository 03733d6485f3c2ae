// crease::effect: a number of a part is out of its range
// (directions)
// directions:0x4/single_layer/hbao
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<0, 4>, single_layer, hbao>::passes.size();
