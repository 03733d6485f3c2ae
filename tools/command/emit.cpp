// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "emit/arguments.hpp"

#include <fmt/format.h>

#include <memory>

namespace crease::tools {

void add_emit(CLI::App& app) {
    CLI::App* command = app.add_subcommand("emit", "every pass of a recipe as GLSL, SPIR-V or a C++ header");
    const auto options = std::make_shared<emit_options>();
    add_emit_arguments(*command, *options);
    command->callback([options] {
        for (const std::filesystem::path& file : emit(*options))
            fmt::print("{}\n", file.string());
    });
}

}
