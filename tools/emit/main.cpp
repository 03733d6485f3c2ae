// SPDX-License-Identifier: MIT
// The part of the command that crease_add_shader runs, so that a host's build needs no more than glslang.
#include "arguments.hpp"
#include "recipe_error.hpp"

#include <fmt/format.h>

int main(int count, char** arguments) {
    CLI::App app{"Emits the shaders of a recipe", "crease_emit"};
    crease::tools::emit_options options;
    crease::tools::add_emit_arguments(app, options);
    app.footer("Exit status: 0 done; 1 it failed; 2 the arguments are wrong.");
    try {
        app.parse(count, arguments);
        crease::tools::emit(options);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "crease_emit: {}\nRun crease_emit --help for its arguments.\n", error.what());
        return 2;
    } catch (const crease::tools::recipe_error& error) {
        fmt::print(stderr, "crease_emit: {}\n", error.what());
        return 2;
    } catch (const std::exception& failure) {
        fmt::print(stderr, "crease_emit: {}\n", failure.what());
        return 1;
    }
    return 0;
}
