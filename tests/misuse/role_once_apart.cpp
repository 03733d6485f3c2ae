// crease::effect: two parts have the same role, and only filters may be more than one
// (compute, fragment)
// directions/single_layer/hbao/compute/bilateral/fragment
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count =
    effect<directions<>, single_layer, hbao, compute<>, bilateral<>, fragment>::passes.size();
