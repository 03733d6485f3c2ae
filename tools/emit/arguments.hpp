// SPDX-License-Identifier: MIT
#pragma once

#include "emit.hpp"

#include <CLI/CLI.hpp>

namespace crease::tools {

/// Adds the arguments of `crease emit` to a command.
inline void add_emit_arguments(CLI::App& command, emit_options& options) {
    command
        .add_option("recipe", options.recipe,
                    "SAMPLER/DEPTH/ESTIMATOR[/FILTER...], as `crease list` names them")
        ->required();
    command.add_option("--stage", options.stage, "what the passes run as")
        ->check(CLI::IsMember({"compute", "fragment"}))
        ->capture_default_str();
    command.add_option("--dialect", options.dialect, "which GLSL")
        ->check(CLI::IsMember({"vulkan", "opengl"}))
        ->capture_default_str();
    command.add_option("--shape", options.shape, "whole programs, or functions for a shader of your own")
        ->check(CLI::IsMember({"program", "functions"}))
        ->capture_default_str();
    static const std::map<std::string, emit_format> formats{{"glsl", emit_format::glsl},
                                                            {"spirv", emit_format::spirv},
                                                            {"spirv-asm", emit_format::spirv_asm},
                                                            {"header", emit_format::header}};
    command.add_option("--format", options.format, "glsl, spirv, spirv-asm or header (a C++ array to embed)")
        ->transform(CLI::CheckedTransformer(formats));
    command.add_option("--name", options.name, "of the header and its namespace")->capture_default_str();
    command.add_option("-o,--output", options.directory, "directory for the files")->required();
}

}
