// crease::effect: the third part must be an estimator
// (directions, single_layer)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer>::passes.size();
