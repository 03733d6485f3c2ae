// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "compositions.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

using namespace crease;

static_assert(recipe("directions:8x4/single_layer/hbao"));
static_assert(recipe("directions/single_layer/hbao").text().view() == "directions:8x4x2/single_layer/hbao");
static_assert(recipe("directions:5/single_layer/hbao").text().view() == "directions:5x4x2/single_layer/hbao");

constexpr choice same[] = {choice_of<directions<8, 4>>(), choice_of<single_layer>(), choice_of<hbao>()};
static_assert(recipe(same).text().view() == "directions:8x4x2/single_layer/hbao");

std::string error_of(std::string_view text) {
    return std::string(recipe(text).error());
}

}

TEST_CASE("a word that is no part is named") {
    CHECK(error_of("direction:8x4/single_layer/hbao") ==
          "crease::recipe: there is no part of the name 'direction'");
    CHECK(error_of("directions/single_layer/hbao ") ==
          "crease::recipe: there is no part of the name 'hbao '");
    CHECK(error_of("Directions/single_layer/hbao") ==
          "crease::recipe: there is no part of the name 'Directions'");
}

TEST_CASE("a missing word is said to be missing") {
    const std::string missing = "crease::recipe: a part's name is missing before or after a '/' in "
                                "'SAMPLER/DEPTH/ESTIMATOR[/...]'";
    CHECK(error_of("") == missing);
    CHECK(error_of("/") == missing);
    CHECK(error_of("directions//hbao") == missing);
    CHECK(error_of("directions/single_layer/hbao/") == missing);
}

TEST_CASE("numbers that cannot be read are quoted") {
    for (const char* word :
         {"directions:", "directions:8x", "directions:x4", "directions:8x4x2x1", "directions:-8",
          "directions:8.0", "directions: 8", "directions:8X4", "directions:9999999999"}) {
        CAPTURE(word);
        CHECK(
            error_of(std::string(word) + "/single_layer/hbao") ==
            "crease::recipe: the numbers after ':' are not whole numbers joined by 'x', as many as the part "
            "takes, in '" +
                std::string(word) + "'");
    }
    CHECK_FALSE(recipe("directions/single_layer:1/hbao"));
}

TEST_CASE("numbers out of range are refused as in an effect") {
    CHECK(error_of("directions:0x4/single_layer/hbao") ==
          "crease::effect: a number of a part is out of its range (directions)");
    CHECK(error_of("directions:999999999/single_layer/hbao") ==
          "crease::effect: a number of a part is out of its range (directions)");
}

TEST_CASE("too many parts are refused, however many") {
    std::string text = "directions/single_layer/hbao";
    for (int i = 0; i < 13; ++i)
        text += "/bilateral";
    CHECK(recipe(text));
    text += "/bilateral";
    CHECK(error_of(text) == "crease::effect: an effect has 16 parts at the most (bilateral)");
    for (int i = 0; i < 100; ++i)
        text += "/bilateral";
    CHECK(error_of(text) == "crease::recipe: there are too many parts, beginning with 'bilateral'");
}

TEST_CASE("a long word does not cut the sentence") {
    const std::string error = error_of(std::string(10'000, 'a') + "/single_layer/hbao");
    CHECK(error == "crease::recipe: there is no part of the name '" + std::string(64, 'a') + "'");
}

TEST_CASE("text and values make the same recipe, and its text reads back") {
    for (const std::string& text : every_recipe()) {
        CAPTURE(text);
        const recipe once(text);
        const std::string whole(once.text().view());
        const recipe again{std::string_view(whole)};
        CHECK(again.text().view() == whole);
        CHECK(recipe(once.choices()).text().view() == whole);
        CHECK_FALSE(once.text().cut);
    }
}

TEST_CASE("a host limits the parts that a recipe may name, and adds its own") {
    static constexpr part own{.kind = role::estimator, .name = "own", .summary = "a host's", .source = ""};
    static constexpr const part* known[] = {&directions_part::description, &single_layer::description, &own};
    CHECK(recipe("directions/single_layer/own", known));
    CHECK(recipe("directions/single_layer/hbao", known).error() ==
          "crease::recipe: there is no part of the name 'hbao'");
}
