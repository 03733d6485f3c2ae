// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/composition.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace crease::tools {

/// What `emit` writes for each pass.
enum class emit_format { glsl, spirv, spirv_asm, header };

struct emit_options {
    std::string recipe;             ///< see crease::recipe
    std::string stage = "compute";  ///< "compute" or "fragment"; unused where the shape is functions
    std::string dialect = "vulkan"; ///< "vulkan" or "opengl"
    std::string shape = "program";  ///< "program" or "functions"
    emit_format format = emit_format::glsl;
    std::string name = "crease_shaders"; ///< of the header and its namespace: a C++ identifier
    std::filesystem::path directory;     ///< made where it is missing
};

/// The recipe with the stage and the dialect that the options add to it.
/// @throws std::runtime_error  with the sentence of the refusal
recipe composed_recipe(const emit_options& options);

/// Writes every pass of a recipe: `<n>_<pass>.comp|.frag|.glsl`, `.spv` or `.spvasm`, a fragment pass with
/// its `fullscreen.vert`; or one header `<name>.hpp` with an array for each pass. SPIR-V is validated before
/// it is written.
/// @return the files written
/// @throws std::runtime_error  with the sentence of the refusal, or where a file cannot be written
std::vector<std::filesystem::path> emit(const emit_options& options);

}
