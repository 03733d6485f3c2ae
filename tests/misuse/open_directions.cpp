// crease::effect: the output needs to know open directions, which the estimator does not
// (bent_cone, bare)
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
                                              .files = crease::hbao_plus::files,
                                              .needs = needs::list};
};

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, bare, bent_cone>::passes.size();
