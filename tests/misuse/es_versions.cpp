// crease::effect: the versions of GLSL ES are 300 and 310
// (glsl_es)
// directions/single_layer/hbao/glsl_es:305
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, glsl_es<305>>::passes.size();
