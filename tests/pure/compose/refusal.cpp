// SPDX-License-Identifier: MIT
// What does not compile (tests/misuse) is refused at run time with the same words.
#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <memory>
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
        const crease::recipe chosen{std::string_view(text)};
        CHECK(std::string(std::make_unique<crease::composition>(chosen)->error()) == sentence + " " + parts);
        ++compared;
    }
    CHECK(compared >= 12);
}

TEST_CASE("a refusal names the parts that it is about, and one that is none says nothing") {
    CHECK(crease::refusal{}.message().view().empty());
    CHECK(crease::refusal{"no", "a"}.message().view() == "crease::effect: no (a)");
    CHECK(crease::refusal{"no", "a", "b"}.message().view() == "crease::effect: no (a, b)");
}
