// SPDX-License-Identifier: MIT
#pragma once

#include "emission.hpp"

#include <crease/compose/recipe.hpp>

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace crease::tools {

/// What `emit` writes of each pass.
enum class emit_format { glsl, spirv, spirv_asm, wgsl, header };

struct emit_options {
    std::string recipe;                   ///< see crease::recipe
    std::optional<std::string> stage{};   ///< "compute" or "fragment"; unset: as the recipe says
    std::optional<std::string> dialect{}; ///< "vulkan", "opengl", "glsl_es:300", ":310" or "webgpu"; unset:
                                          ///< as the recipe says
    std::optional<std::string> shape{};   ///< "program" or "functions"; unset: as the recipe says
    std::set<emit_format> formats{};      ///< none: GLSL
    std::optional<translate::language> target{}; ///< in place of formats
    std::optional<unsigned> target_version{};    ///< of the target; unset: 50, 21, 310 or 430
    spirv_options spirv{};                       ///< refused where no SPIR-V is made
    std::string name = "crease_shaders"; ///< of the header, its namespace and the manifest; see expect_name
    std::filesystem::path directory;     ///< made where it is missing
};

/// The recipe with the stage, the dialect and the shape that the options add to it.
/// @throws recipe_error  with the sentence of the refusal, also where recipe and options disagree
recipe composed_recipe(const emit_options& options);

/// Writes every pass of a recipe: `<n>_<pass>.comp|.frag|.glsl`, `.spv`, `.spvasm`, `.wgsl`, `.hlsl` or
/// `.metal`, with `fullscreen.vert` of fragment passes; or one header `<name>.hpp`; and beside them the
/// manifest
/// `<name>.json`, which says what belongs together. What the manifest that stood there named and no longer
/// belongs goes. Where it fails there is no manifest, or that of what stood there.
/// @return the files written, the manifest last
/// @throws recipe_error        with the sentence of the refusal
/// @throws std::runtime_error  where a file cannot be written, or stands in the way
std::vector<std::filesystem::path> emit(emit_options options);

}
