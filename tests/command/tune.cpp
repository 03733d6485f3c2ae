// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <doctest/doctest.h>

namespace {

/// A search of a few candidates on the built-in scene.
std::string search_in(const temporary_folder& folder, const std::string& more) {
    return "tune built-in --width 32 --height 18 --rays 4 --repeats 1 --recipes "
           "directions:2x2/single_layer/hbao --recipes half_directions:1x4/single_layer/cosine_bitmask:1 -o "
           "'" +
           (folder / "out").string() + "' " + more;
}

std::vector<std::string> candidates_in(const nlohmann::json& state) {
    std::vector<std::string> all;
    for (const nlohmann::json& each : state.at("trials"))
        all.push_back(each.at("candidate"));
    return all;
}

}

TEST_CASE("tune: a search ends with its front, and goes on to the same candidates as one in a piece") {
    const temporary_folder once, twice;
    expect_success(search_in(once, "--trials 6"));
    expect_success(search_in(twice, "--trials 3"));
    const std::vector<std::string> first = candidates_in(json_in(twice / "out/state.json"));
    const std::string said = expect_success(search_in(twice, "--trials 6"));
    const nlohmann::json state = json_in(once / "out/state.json");
    const std::vector<std::string> all = candidates_in(state);
    REQUIRE(all.size() == 6);
    CHECK(all[0] == "directions:2x2/single_layer/hbao");
    CHECK(candidates_in(json_in(twice / "out/state.json")) == all);
    CHECK(first == std::vector<std::string>(all.begin(), all.begin() + 3));

    const nlohmann::json front = json_in(twice / "out/front.json").at("front");
    REQUIRE(front.size() >= 1);
    for (std::size_t i = 0; i < front.size(); ++i) {
        CHECK(front[i].at("instructions").get<double>() > 0);
        CHECK(front[i].at("fetches").get<double>() > 0);
        CHECK(front[i].at("milliseconds").get<double>() > 0);
        CHECK(front[i].at("error_kept_out").get<double>() > 0);
        CHECK(said.find(front[i].at("candidate").get<std::string>()) != std::string::npos);
        if (i > 0) {
            CHECK(front[i]["instructions"].get<double>() > front[i - 1]["instructions"].get<double>());
            CHECK(front[i]["error"].get<double>() < front[i - 1]["error"].get<double>());
        }
    }
    CHECK(content_of(twice / "out/front.svg").ends_with("</svg>\n"));
}

TEST_CASE("tune: an interrupt leaves a state that is whole, and no front") {
    const temporary_folder folder;
    const std::string state = (folder / "out/state.json").string(),
                      complained = (folder / "complained").string();
    const ended done = crease_command(search_in(folder, "--trials 10000") + " 2>'" + complained +
                                      "' & for i in $(seq 600); do [ -f '" + state +
                                      "' ] && break; sleep 0.1; done; kill -INT $!; wait $!; exit $? #");
    CHECK(done.status == 1);
    CHECK(content_of(complained).find("interrupted after ") != std::string::npos);
    CHECK(content_of(complained).find("the same command goes on") != std::string::npos);
    const std::size_t tried = json_in(folder / "out/state.json").at("trials").size();
    CHECK(tried >= 1);
    CHECK_FALSE(std::filesystem::exists(folder / "out/front.json"));
    expect_success(search_in(folder, "--trials " + std::to_string(tried + 1)));
    CHECK(json_in(folder / "out/state.json").at("trials").size() == tried + 1);
    CHECK(std::filesystem::exists(folder / "out/front.json"));
}

TEST_CASE("tune: the best within a budget is named, and that there is none") {
    const temporary_folder folder;
    CHECK(expect_success(search_in(folder, "--trials 2 --budget-error 1"))
              .find("best within the budget: directions:2x2/single_layer/hbao\n") != std::string::npos);
    const ended other = crease_command(search_in(folder, "--trials 2 --budget-error 0.5"));
    CHECK(other.status == 1);
    CHECK(other.complained.find("is of a search over other views, with another truth, budget, seed") !=
          std::string::npos);
    const temporary_folder strict;
    CHECK(expect_success(search_in(strict, "--trials 2 --truth hard --budget-instructions 10"))
              .find("no candidate keeps to the budget") != std::string::npos);
    CHECK(json_in(strict / "out/front.json").at("best").is_null());
}

TEST_CASE("tune: a single view, two budgets and recipes that are none are refused") {
    const temporary_folder folder;
    const auto refused = [&](const std::string& more) {
        const ended done = crease_command(search_in(folder, more));
        CHECK(done.status != 0);
        return done.complained;
    };
    CHECK(refused("--cameras overview").find("a search needs two views or more") != std::string::npos);
    CHECK(refused("--budget-ms 1 --budget-error 1").find("budget") != std::string::npos);
    CHECK(refused("--recipes nothing").find("there is no part of the name 'nothing'") != std::string::npos);
    CHECK(refused("--budget-ms nan").find("is not a number from 0") != std::string::npos);
}
