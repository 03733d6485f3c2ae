// crease::effect: the stage keeps depths in shared memory, and a part needs layers with their opacity
// (compute_strips, every_layer)
// axes/linked_lists/hbao/every_layer/compute_strips
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<axes<>, linked_lists<>, hbao, every_layer, compute_strips<>>::passes.size();
