// crease::effect: a number of a part is out of its range
// (bilateral)
// directions/single_layer/hbao/bilateral:17
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, bilateral<17>>::passes.size();
