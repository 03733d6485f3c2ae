// SPDX-License-Identifier: MIT
#include <crease/effect/version.hpp>

#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

static_assert(CREASE_VERSION ==
              10000 * CREASE_VERSION_MAJOR + 100 * CREASE_VERSION_MINOR + CREASE_VERSION_PATCH);
#if CREASE_VERSION < 200
#error "the number grows with the version, also for the preprocessor"
#endif

namespace {

const std::string from_macros = std::to_string(CREASE_VERSION_MAJOR) + "." +
                                std::to_string(CREASE_VERSION_MINOR) + "." +
                                std::to_string(CREASE_VERSION_PATCH);

/// The headings of releases, newest first: "0.2.0] - 2026-11-30".
std::vector<std::string> releases() {
    std::ifstream changelog(CREASE_CHANGELOG);
    std::vector<std::string> all;
    for (std::string line; std::getline(changelog, line);)
        if (line.starts_with("## [") && line != "## [Unreleased]")
            all.push_back(line.substr(4));
    return all;
}

}

TEST_CASE("the version is that of the macros and of the package") {
    CHECK(crease::version == from_macros);
    CHECK(crease::version == CREASE_PROJECT_VERSION);
}

TEST_CASE("the newest release of the changelog is this version") {
    const std::vector<std::string> all = releases();
    REQUIRE(all.size() >= 2);
    CHECK(all[0].starts_with(std::string(crease::version) + "] - 20"));
    CHECK(all.back().starts_with("0.1.0] - 20"));
}
