// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace crease::tools {

// Each adds one subcommand, with its arguments and what it does.
void add_list(CLI::App& app);
void add_emit(CLI::App& app);
void add_render(CLI::App& app);
void add_reference(CLI::App& app);
void add_compare(CLI::App& app);
void add_bench(CLI::App& app);
void add_demo(CLI::App& app);

}
