// crease::effect: GLSL ES and WebGPU change no image of several numbers in place, as a part does
// (n_buffer, glsl_es)
// box_area/n_buffer/unsharp_mask/glsl_es:310
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count = effect<box_area<>, n_buffer<>, unsharp_mask, glsl_es<>>::passes.size();
