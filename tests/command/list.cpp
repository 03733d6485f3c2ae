// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <crease/compose/recipe.hpp>
#include <crease/effect/version.hpp>
#include <crease/parts/all_parts.hpp>

#include <doctest/doctest.h>

namespace {

unsigned occurrences(const std::string& of, const std::string& in) {
    unsigned count = 0;
    for (std::size_t at = in.find(of); at != std::string::npos; at = in.find(of, at + 1))
        ++count;
    return count;
}

}

TEST_CASE("list: the version and the exit status are told") {
    CHECK(expect_success("--version") == "crease " + std::string(crease::version) + "\n");
    CHECK(expect_success("--help").find("Exit status: 0 done; 1 it failed; 2 the arguments are wrong.") !=
          std::string::npos);
    CHECK(crease_command("list >/dev/full; exit $? #").status == 1);
}

TEST_CASE("list: as JSON it holds every part, and recipes that compose") {
    const nlohmann::json listed = nlohmann::json::parse(expect_success("list --json"));
    REQUIRE(listed.at("parts").size() == std::size(crease::all_parts));
    for (std::size_t i = 0; i < listed["parts"].size(); ++i) {
        const crease::part& p = *crease::all_parts[i];
        const nlohmann::json& shown = listed["parts"][i];
        CHECK(shown.at("name").get<std::string>() == p.name);
        CHECK(shown.at("role").get<std::string>() == crease::name_of(p.kind));
        CHECK(shown.at("summary").get<std::string>() == p.summary);
        REQUIRE(shown.at("settings").size() == p.settings.size());
        for (std::size_t s = 0; s < p.settings.size(); ++s) {
            CHECK(shown["settings"][s].at("name").get<std::string>() == p.settings[s].name);
            CHECK(shown["settings"][s].at("default").get<float>() == p.settings[s].fallback);
            CHECK(shown["settings"][s].at("least").get<float>() == p.settings[s].least);
            CHECK(shown["settings"][s].at("most").get<float>() == p.settings[s].most);
            CHECK(shown["settings"][s].at("shared").get<bool>() == p.settings[s].shared);
        }
        REQUIRE(shown.at("numbers").size() == p.numbers.size());
        for (std::size_t n = 0; n < p.numbers.size(); ++n) {
            CHECK(shown["numbers"][n].at("name").get<std::string>() == p.numbers[n].name);
            CHECK(shown["numbers"][n].at("default").get<int>() == p.numbers[n].fallback);
        }
    }
    std::set<std::string> recipes;
    for (const nlohmann::json& r : listed.at("recipes")) {
        const std::string text = r.at("recipe");
        CHECK(crease::recipe(std::string_view(text)));
        CHECK(r.at("features").at("extended_storage_formats").is_boolean());
        recipes.insert(text);
    }
    CHECK(recipes.size() == listed["recipes"].size());
    CHECK(recipes.contains("directions/single_layer/hbao"));
    CHECK_FALSE(recipes.contains("poisson_disk/single_layer/hbao"));
}

TEST_CASE("list: as text it names the same") {
    const std::string text = expect_success("list");
    for (const crease::part* p : crease::all_parts) {
        CAPTURE(std::string(p->name));
        CHECK(text.find("\n  " + std::string(p->name) + " ") != std::string::npos);
    }
    CHECK(text.find("\n  directions/single_layer/hbao") != std::string::npos);
}

TEST_CASE("list: as text each role has one heading, in the order of the index, before its parts") {
    const std::string text = expect_success("list");
    std::size_t last = 0;
    for (const crease::part* p : crease::all_parts) {
        CAPTURE(std::string(p->name));
        const std::string heading = "\n\n" + std::string(crease::name_of(p->kind)) + "\n  ";
        CHECK(occurrences(heading, "\n" + text) == 1);
        const std::size_t at = ("\n" + text).find(heading);
        CHECK(at >= last);
        CHECK(text.find("\n  " + std::string(p->name) + " ") > at);
        last = at;
    }
}

TEST_CASE("list: as text a setting reads as --set takes it, with its part where it is the part's own") {
    const std::string text = expect_success("list");
    CHECK(occurrences("--set hbao.bias=", text) == 1);
    CHECK(occurrences("--set bilateral.sharpness=", text) == 1);
    CHECK(occurrences("--set plane_reach=0.05 (0 to 10, for all parts that have it)", text) >= 1);
    CHECK(occurrences("--set strength=1.15 (0 to 16, for all parts that have it)", text) >= 1);
    CHECK(occurrences("hbao.strength", text) == 0);
}
