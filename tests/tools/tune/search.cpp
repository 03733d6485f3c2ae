// SPDX-License-Identifier: MIT
#include "tune/search.hpp"

#include "command/candidate.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <set>

using namespace crease::tools;

namespace {

trial costing(double instructions, double error, double milliseconds = 1) {
    return {"directions:4x4/single_layer/hbao", error, milliseconds, instructions, 0, ""};
}

}

TEST_CASE("the front holds what nothing else beats in both cost and error, from the cheapest on") {
    trial refused = costing(1, 0.001), endless = costing(std::numeric_limits<double>::infinity(), 0.001, 9);
    refused.refused = "it cannot be run";
    const trial trials[] = {costing(300, 0.05, 1),
                            costing(100, 0.09, 3),
                            costing(200, 0.09, 2),
                            costing(400, 0.06, 4),
                            costing(100, 0.08, 5),
                            refused,
                            endless};
    CHECK(front_of(trials, {}) == std::vector<std::size_t>{4, 0});
    // By milliseconds what has no count of instructions has its place too.
    CHECK(front_of(trials, {.milliseconds = 20, .instructions = {}, .error = {}}) ==
          std::vector<std::size_t>{0, 6});
}

TEST_CASE("within a budget of cost the least error is best, within one of error the cheapest") {
    const trial trials[] = {costing(300, 0.05), costing(100, 0.09), costing(200, 0.07)};
    const auto best = [&](std::optional<double> instructions, std::optional<double> error) {
        return best_of(trials, {.milliseconds = {}, .instructions = instructions, .error = error});
    };
    CHECK(best(250, {}) == 2u);
    CHECK(best(300, {}) == 0u);
    CHECK_FALSE(best(99, {}));
    CHECK(best({}, 0.09) == 1u);
    CHECK(best({}, 0.08) == 2u);
    CHECK_FALSE(best({}, 0.04));
    CHECK_FALSE(best({}, {}));
}

TEST_CASE("each next candidate is new, makes an effect, and follows from the seed") {
    std::vector<trial> trials = {costing(300, 0.05), costing(100, 0.09)};
    trials[1].candidate = "preset:medium@strength=0.9";
    const std::string whole = "directions:4x4x2/single_layer/hbao"; // the first with all its numbers
    std::set<std::string> known = {trials[0].candidate, trials[1].candidate, whole};
    std::set<std::string> of_another_seed;
    for (int i = 0; i < 60; ++i) {
        const auto next = next_candidate(trials, {}, 3);
        REQUIRE(next);
        CAPTURE(*next);
        CHECK(next == next_candidate(trials, {}, 3));
        CHECK(known.insert(*next).second);
        CHECK_NOTHROW(parse_candidate(*next));
        of_another_seed.insert(next_candidate(trials, {}, 4).value());
        trials.push_back(costing(100 + i % 7, 0.09 - i * 1e-4)); // which keeps the front changing
        trials.back().candidate = *next;
    }
    CHECK(of_another_seed.size() > 30);
    const auto changed = [&](const char* word) {
        return std::ranges::any_of(known,
                                   [&](const std::string& text) { return text.find(word) != text.npos; });
    };
    CHECK(changed("noise"));
    CHECK(changed("@"));
    CHECK(changed("bilateral"));
    CHECK_FALSE(changed("orthographic"));
    CHECK_FALSE(changed("opengl"));
}

TEST_CASE("without a trial that could be run there is no next candidate") {
    trial refused = costing(1, 0);
    refused.refused = "it cannot be run";
    CHECK_FALSE(next_candidate({}, {}, 1));
    CHECK_FALSE(next_candidate({&refused, 1}, {}, 1));
}
