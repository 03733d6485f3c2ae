// crease::effect: GLSL ES and WebGPU have no way to capture layers, which a part needs
// (multisampled, glsl_es)
// directions/stochastic_layers/hbao/multisampled/glsl_es:310
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

constexpr auto count =
    effect<directions<>, stochastic_layers<>, hbao, multisampled<>, glsl_es<>>::passes.size();
