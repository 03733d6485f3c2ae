// crease::effect: GLSL ES and WebGPU promise no operations of subgroups, which a part needs
// (subgroup_scan, glsl_es)
// sample_box/summed_area/mean_height/subgroup_scan/glsl_es:310
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count =
    effect<sample_box, summed_area<>, mean_height<>, subgroup_scan, glsl_es<>>::passes.size();
