// crease::effect: the fold needs a test of the front surface, which the estimator does not have
// (front_first, bare)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

// An estimator that only weighs.
struct bare {
    using needs = crease::traits<crease::screen_taps, crease::depth_layers>;
    static constexpr crease::part description{.kind = crease::role::estimator,
                                              .name = "bare",
                                              .summary = "",
                                              .source = "",
                                              .glsl = &crease::hbao_plus_glsl,
                                              .needs = needs::list};
};

using namespace crease;

constexpr auto count = effect<directions<>, stochastic_layers<>, bare, front_first<>>::passes.size();
