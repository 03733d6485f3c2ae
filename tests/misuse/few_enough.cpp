// crease::effect: an effect has 16 parts at the most
// (bilateral)
// directions/single_layer/hbao/bilateral/bilateral/bilateral/bilateral/bilateral/bilateral/bilateral/bilateral/bilateral/bilateral/bilateral/bilateral/bilateral/bilateral
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, bilateral<>, bilateral<>, bilateral<>,
                              bilateral<>, bilateral<>, bilateral<>, bilateral<>, bilateral<>, bilateral<>,
                              bilateral<>, bilateral<>, bilateral<>, bilateral<>, bilateral<>>::passes.size();
