// crease::effect: a fourth or later part must be a filter, a view part, a stage or a dialect
// (ssao)
// directions/single_layer/hbao/ssao
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, ssao>::passes.size();
