// crease::effect: GLSL ES 3.00 has fragment shaders alone, and a part needs others
// (compute, glsl_es)
// directions/single_layer/hbao/compute/glsl_es:300
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, compute<>, glsl_es<300>>::passes.size();
