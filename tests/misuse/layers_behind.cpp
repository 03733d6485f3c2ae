// crease::effect: the layer traversal comes back to a tap after others, and the estimator cannot add to it then
// (deferred_layers, bare)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

// An estimator that goes through its taps once.
struct bare {
    using needs = crease::traits<crease::screen_taps, crease::depth_layers>;
    static constexpr crease::part description{.kind = crease::role::estimator,
                                              .name = "bare",
                                              .summary = "",
                                              .source = "",
                                              .files = crease::hbao_plus::files,
                                              .needs = needs::list};
};

using namespace crease;

constexpr auto count = effect<directions<>, stochastic_layers<>, bare, deferred_layers<>>::passes.size();
