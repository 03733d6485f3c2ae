// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <sstream>

using crease::tools::progress;

TEST_CASE("progress: a log gets one line a quarter") {
    std::ostringstream log;
    progress shown("tracing", log, false);
    for (const double fraction : {0.1, 0.25, 0.3, 0.2, 0.8, 1.0, 1.0, 2.0})
        shown(fraction);
    CHECK(log.str() == "tracing: 0 %\ntracing: 25 %\ntracing: 50 %\ntracing: 75 %\ntracing: 100 %\n");
}

TEST_CASE("progress: a terminal gets a bar that fills once") {
    std::ostringstream terminal;
    progress shown("tracing", terminal, true);
    CHECK(terminal.str().starts_with("tracing\n"));
    for (const double fraction : {0.5, 0.4, 1.0, 1.0})
        shown(fraction);
    const std::string text = terminal.str();
    CHECK(std::count(text.begin(), text.end(), '*') == 51);
    CHECK(text.ends_with("*\n"));
}
