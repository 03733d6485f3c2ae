// crease::effect: layers are needed with their opacity, and the depth source keeps depths alone
// (every_layer, single_layer)
// directions/single_layer/hbao/every_layer
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, every_layer>::passes.size();
