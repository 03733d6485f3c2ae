// crease::effect: layers are weighed by their opacity, and the layer traversal takes the front one from the depth image, which tells none
// (every_layer, front_first)
// directions/linked_lists/hbao/every_layer/front_first
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, linked_lists<>, hbao, every_layer, front_first<>>::passes.size();
