// crease::effect: two parts have the same role, and only filters may be more than one
// (perspective, orthographic)
// directions/single_layer/hbao/perspective/orthographic
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, perspective, orthographic>::passes.size();
