// SPDX-License-Identifier: MIT
#include <crease/compose/interface_text.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <string_view>

namespace {

std::string written(const crease::interface_text& text) {
    std::string all(text.size(), ' ');
    text.write(all.data());
    return all;
}

}

TEST_CASE("words of every length follow each other at every byte of a word") {
    const std::string_view letters = "abcdefghijklmnopqrstuvwxyz";
    for (std::size_t before = 0; before < 20; ++before)
        for (std::size_t length = 0; length <= letters.size(); ++length) {
            crease::interface_text text;
            text << letters.substr(0, before) << letters.substr(0, length) << "." << letters;
            const std::string wanted = std::string(letters.substr(0, before)) +
                                       std::string(letters.substr(0, length)) + "." + std::string(letters);
            CHECK(written(text) == wanted);
        }
}

TEST_CASE("numbers are written with all their digits") {
    for (int number : {0, 7, 10, 99, 100, 1023, 12345678, 99999999, 100000000, 100000007, 2147483647, -1, -10,
                       std::numeric_limits<int>::min() + 1}) {
        crease::interface_text text;
        text << "x" << number << ";";
        CHECK(written(text) == "x" + std::to_string(number) + ";");
    }
    crease::interface_text text;
    text << 4294967295u;
    CHECK(written(text) == "4294967295");
}

TEST_CASE("a text fits up to its last character, and what does not is left out") {
    crease::interface_text text;
    for (std::size_t i = 0; i < crease::interface_text::most_characters / 8; ++i)
        text << "eight...";
    CHECK(text.size() == crease::interface_text::most_characters);
    CHECK_FALSE(text.is_cut());
    text << "x";
    CHECK(text.is_cut());
    CHECK(text.size() == crease::interface_text::most_characters);
}
