// crease::effect: the filter weighs by normals, and the output hands on none
// (plane_filter, no_normals)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

// An output that keeps no normal.
struct no_normals {
    static constexpr crease::part description{.kind = crease::role::output,
                                              .name = "no_normals",
                                              .summary = "",
                                              .source = "",
                                              .files = crease::visibility_only::files,
                                              .resources = crease::visibility_only::images};
};

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, no_normals, plane_filter<>>::passes.size();
