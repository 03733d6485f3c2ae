// SPDX-License-Identifier: MIT
#pragma once

#include "emit.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <string>

namespace crease::tools {

/// Adds an option whose words stand for values; with commas between several where it takes more than one.
template <class Value, class Use>
void add_choice(CLI::App& command, const std::string& name, const std::string& meaning,
                const std::map<std::string, Value>& words, bool takes_several, Use use) {
    std::string all;
    for (const auto& [word, value] : words)
        all += (all.empty() ? "" : ",") + word;
    const auto read = [=](const std::string& said) {
        if (said.empty())
            throw CLI::ValidationError(name, "nothing follows; it takes {" + all + "}");
        std::istringstream rest(said);
        for (std::string word; std::getline(rest, word, takes_several ? ',' : '\0');) {
            if (!words.contains(word))
                throw CLI::ValidationError(name, word + " not in {" + all + "}");
            use(words.at(word));
        }
    };
    command.add_option_function<std::string>(name, read, meaning)->type_name("{" + all + "}");
}

/// Adds the arguments of `crease emit` to a command.
inline void add_emit_arguments(CLI::App& command, emit_options& options) {
    command
        .add_option("recipe", options.recipe,
                    "SAMPLER/DEPTH/ESTIMATOR[/FILTER...], as `crease list` names them")
        ->required();
    command
        .add_option("--stage", options.stage, "what the passes run as; else as the recipe says, or compute")
        ->check(CLI::IsMember({"compute", "fragment"}));
    command.add_option("--dialect", options.dialect, "which GLSL; else as the recipe says, or vulkan")
        ->check(CLI::IsMember({"vulkan", "opengl", "glsl_es:300", "glsl_es:310", "webgpu"}));
    command
        .add_option("--shape", options.shape,
                    "whole programs, or functions for a shader of your own; else as the recipe says")
        ->check(CLI::IsMember({"program", "functions"}));

    add_choice<emit_format>(
        command, "--format",
        "one or, with commas, several; header is C++ with all that a host needs; else glsl",
        {{"glsl", emit_format::glsl},
         {"spirv", emit_format::spirv},
         {"spirv-asm", emit_format::spirv_asm},
         {"header", emit_format::header}},
        true, [&options](emit_format format) { options.formats.insert(format); });
    using translate::language;
    const auto translated = [](language to) { return [to](emit_options& chosen) { chosen.target = to; }; };
    const auto formatted = [](emit_format format) {
        return [format](emit_options& chosen) { chosen.formats.insert(format); };
    };
    add_choice<std::function<void(emit_options&)>>(
        command, "--target", "another language, in place of --format",
        {{"hlsl", translated(language::hlsl)},
         {"msl", translated(language::msl)},
         {"glsl-es", translated(language::glsl_es)},
         {"glsl", translated(language::glsl)},
         {"wgsl", formatted(emit_format::wgsl)},
         {"spirv", formatted(emit_format::spirv)}},
        false, [&options](const auto& choose) { choose(options); });
    command.add_option("--target-version", options.target_version,
                       "of the language: 50, 51, 60 of HLSL; 21 (for 2.1) to 30 of MSL; 300, 310, 320 of "
                       "GLSL ES; 430 to 460 of GLSL; else 50, 21, 310, 430");
    add_choice<spirv::goal>(command, "--optimise", "SPIR-V by SPIRV-Tools",
                            {{"speed", spirv::goal::speed}, {"size", spirv::goal::size}}, false,
                            [&options](spirv::goal aim) { options.spirv.optimise = aim; });
    command.add_flag("--strip", options.spirv.strip, "SPIR-V without the names that debuggers show");
    add_choice<spirv::vulkan_version>(
        command, "--target-env", "what SPIR-V is for; else vulkan1.1",
        {{"vulkan1.0", spirv::vulkan_version::v1_0},
         {"vulkan1.1", spirv::vulkan_version::v1_1},
         {"vulkan1.2", spirv::vulkan_version::v1_2},
         {"vulkan1.3", spirv::vulkan_version::v1_3}},
        false, [&options](spirv::vulkan_version version) { options.spirv.target = version; });
    command
        .add_option("--name", options.name, "of the header and its namespace, and of the manifest NAME.json")
        ->capture_default_str();
    command.add_option("-o,--output", options.directory, "directory for the files")->required();
}

}
