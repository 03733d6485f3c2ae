// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <fmt/format.h>

int main(int count, char** arguments) {
    CLI::App app{"Ambient-occlusion shaders: list, emit, render, measure", "crease"};
    app.require_subcommand(1);
    crease::tools::add_list(app);
    crease::tools::add_emit(app);
    crease::tools::add_render(app);
    crease::tools::add_reference(app);
    crease::tools::add_compare(app);
    crease::tools::add_bench(app);
    crease::tools::add_demo(app);
    try {
        app.parse(count, arguments);
    } catch (const CLI::ParseError& end) {
        return app.exit(end); // help is one of these, with status 0
    } catch (const std::exception& failure) {
        fmt::print(stderr, "crease: {}\n", failure.what());
        return 1;
    }
    return 0;
}
