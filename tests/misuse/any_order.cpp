// crease::effect: the fold comes back to a tap after others, and the output takes taps in order
// (deferred_layers, bent_cone)
// directions/stochastic_layers/hbao/deferred_layers/bent_cone
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count =
    effect<directions<>, stochastic_layers<>, hbao, deferred_layers<>, bent_cone>::passes.size();
