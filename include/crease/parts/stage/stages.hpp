// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>
#include <crease/effect/pass.hpp>

namespace crease {

/// Runs as fragment shaders of a triangle that covers the output.
CREASE_TRAIT(fragment_programs, stage, "the stage must be of fragment shaders, and it is not");

/// Is not a program of its own, but functions for one of the host.
CREASE_TRAIT(hosted_functions, stage, "the stage must be of functions, and it is not");

/// What the main pass and filters run as with a stage.
constexpr stage_kind stage_of(const part& p) {
    return has(p.offers, &fragment_programs::value)  ? stage_kind::fragment
           : has(p.offers, &hosted_functions::value) ? stage_kind::functions
                                                     : stage_kind::compute;
}

/// Writes GLSL for OpenGL.
CREASE_TRAIT(opengl_words, dialect, "the dialect must be that of OpenGL, and it is not");

/// Writes GLSL ES.
CREASE_TRAIT(glsl_es_words, dialect, "the dialect must be that of OpenGL ES, and it is not");

/// Writes GLSL of whose SPIR-V naga makes WGSL.
CREASE_TRAIT(webgpu_words, dialect, "the dialect must be that of WebGPU, and it is not");

/// What passes are written in with a dialect.
constexpr dialect_kind dialect_of(const part& p) {
    return has(p.offers, &opengl_words::value)    ? dialect_kind::opengl
           : has(p.offers, &glsl_es_words::value) ? dialect_kind::glsl_es
           : has(p.offers, &webgpu_words::value)  ? dialect_kind::webgpu
                                                  : dialect_kind::vulkan;
}

}
