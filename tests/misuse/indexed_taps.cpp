// crease::effect: the fold comes back to single taps, which the sampler proposes in order only
// (deferred_layers, poisson_disk)
// poisson_disk/stochastic_layers/hbao_plus/deferred_layers
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count =
    effect<poisson_disk<>, stochastic_layers<>, hbao_plus, deferred_layers<>>::passes.size();
