// SPDX-License-Identifier: MIT
#include <crease/interface_text.hpp>

#include <doctest/doctest.h>

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
    for (int number : {0, 7, 10, 99, 100, 1023, 12345678, 99999999, 100000000, 100000007, 2147483647}) {
        crease::interface_text text;
        text << "x" << number << ";";
        CHECK(written(text) == "x" + std::to_string(number) + ";");
        CHECK(crease::digits_of(number) == std::to_string(number).size());
    }
}

TEST_CASE("an open number leaves a gap") {
    crease::interface_text text;
    text << "one " << crease::open_number::of(0, 0) << ", two " << crease::open_number::of(2, 1) << ";\n";
    CHECK(written(text) == "one , two ;\n");
    REQUIRE(text.gaps().size() == 2);
    CHECK(text.gaps()[0].before == 4);
    CHECK(text.gaps()[0].number == crease::open_number::of(0, 0));
    CHECK(text.gaps()[1].before == 6);
    CHECK(text.gaps()[1].number == crease::open_number::of(2, 1));
    CHECK(text.after_gaps() == 2);
}

TEST_CASE("what does not fit is left out") {
    crease::interface_text text;
    for (int i = 0; i < 1000; ++i)
        text << "eight...";
    CHECK(text.size() == crease::interface_text::most_characters);
}
