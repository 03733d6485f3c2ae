// crease::effect: the third part must be an estimator
// (bilateral)
// directions/single_layer/bilateral
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, bilateral<>>::passes.size();
