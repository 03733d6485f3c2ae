// SPDX-License-Identifier: MIT
// What does not compile (tests/misuse) is refused at run time with the same words.
#include <crease/recipe.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace {

std::string comment(std::istream& from) {
    std::string line;
    std::getline(from, line);
    REQUIRE(line.starts_with("// "));
    return line.substr(3);
}

}

TEST_CASE("a recipe is refused with the sentence of the static assertion") {
    int compared = 0;
    for (const auto& entry : std::filesystem::directory_iterator(CREASE_MISUSE)) {
        if (entry.path().extension() != ".cpp")
            continue;
        CAPTURE(entry.path().string());
        std::ifstream file(entry.path());
        const std::string sentence = comment(file), parts = comment(file), text = comment(file);
        if (text == "no recipe says this")
            continue;
        CHECK(std::string(crease::recipe(std::string_view(text)).error()) == sentence + " " + parts);
        ++compared;
    }
    CHECK(compared >= 12);
}
