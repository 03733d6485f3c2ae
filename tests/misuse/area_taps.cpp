// crease::effect: the depth source holds means over areas, and the sampler proposes single texels
// (summed_area, four_texels)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

// A window whose taps are its texels.
struct four_texels {
    static constexpr part description{.kind = role::sampler,
                                      .name = "four_texels",
                                      .summary = "",
                                      .source = "",
                                      .offers = traits<window_taps>::list};
};

constexpr auto count = effect<four_texels, summed_area<>, unsharp_mask>::passes.size();
