// crease::effect: the second view needs a layer traversal that looks at no depth image, as there is none of the second camera
// (second_view, front_first)
// directions/stochastic_layers/hbao_plus/second_view/front_first
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count =
    effect<directions<>, stochastic_layers<>, hbao_plus, second_view<>, front_first<>>::passes.size();
