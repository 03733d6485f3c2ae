// crease::effect: GLSL ES 3.00 has no storage images, which a part loads
// (image_load, glsl_es)
// directions/single_layer/hbao/image_load/fragment/glsl_es:300
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count =
    effect<directions<>, single_layer, hbao, image_load, fragment, glsl_es<300>>::passes.size();
