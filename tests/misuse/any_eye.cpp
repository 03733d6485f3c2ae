// crease::effect: the second view needs an estimator that works from any eye, which this one does not
// (second_view, hbao)
// directions/stochastic_layers/hbao/second_view
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, stochastic_layers<>, hbao, second_view<>>::passes.size();
