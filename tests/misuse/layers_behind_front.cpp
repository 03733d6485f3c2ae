// crease::effect: the layer traversal looks behind the front surface, and the depth source holds nothing there
// (front_first, single_layer)
// directions/single_layer/hbao/front_first
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, front_first<>>::passes.size();
