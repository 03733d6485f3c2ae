// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace crease::tools {

/// An option that may be repeated. Each time it takes one value, so that the arguments behind it stay what
/// they are.
inline CLI::Option* add_each(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                             const std::string& meaning) {
    return command.add_option(name, values, meaning + "; may be repeated")->allow_extra_args(false);
}

// Each adds one subcommand, with its arguments and what it does.
void add_list(CLI::App& app);
void add_emit(CLI::App& app);
void add_render(CLI::App& app);
void add_reference(CLI::App& app);
void add_compare(CLI::App& app);
void add_bench(CLI::App& app);
void add_demo(CLI::App& app);

}
