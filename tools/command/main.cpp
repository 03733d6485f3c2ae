// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "frame/frame.hpp"

#include <crease/effect/version.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <new>
#include <string>
#include <string_view>

namespace {

enum status { success = 0, failure = 1, usage = 2 };

/// Says what went wrong: with the name of the command once, whatever named itself before.
status complain(std::string_view sentence, status ends_with) {
    if (const std::size_t colon = sentence.find(": ");
        sentence.starts_with("crease::") && sentence.find(' ') == colon + 1)
        sentence.remove_prefix(colon + 2);
    fmt::print(stderr, "crease: {}\n", sentence);
    return ends_with;
}

status run(CLI::App& app, int count, char** arguments) {
    try {
        app.parse(count, arguments);
    } catch (const CLI::Success& help) {
        app.exit(help);
    } catch (const CLI::ParseError& error) {
        complain(error.what(), usage);
        std::string command = "crease";
        for (const CLI::App* named : app.get_subcommands())
            command += " " + named->get_name();
        fmt::print(stderr, "Run {} --help for its arguments.\n", command);
        return usage;
    } catch (const crease::tools::recipe_error& error) {
        return complain(error.what(), usage);
    } catch (const std::bad_alloc&) {
        return complain("there is not enough memory for this", failure);
    } catch (const std::exception& error) {
        return complain(error.what(), failure);
    }
    return std::fflush(stdout) == 0 ? success : complain("cannot write to the standard output", failure);
}

}

int main(int count, char** arguments) {
    CLI::App app{"Ambient-occlusion shaders: list, emit, render, measure", "crease"};
    app.set_version_flag("--version", "crease " + std::string(crease::version));
    app.footer("Exit status: 0 done; 1 it failed; 2 the arguments are wrong.");
    app.require_subcommand(1);
    crease::tools::add_list(app);
    crease::tools::add_emit(app);
    crease::tools::add_render(app);
    crease::tools::add_reference(app);
    crease::tools::add_compare(app);
    crease::tools::add_bench(app);
    crease::tools::add_demo(app);
    return run(app, count, arguments);
}
