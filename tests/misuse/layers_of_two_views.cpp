// crease::effect: the second view needs layers of two cameras, and the depth source holds those of one
// (second_view, single_layer)
// directions/single_layer/hbao_plus/second_view
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao_plus, second_view<>>::passes.size();
