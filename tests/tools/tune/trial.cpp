// SPDX-License-Identifier: MIT
#include "tune/trial.hpp"

#include "temporary_folder.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace crease::tools;

TEST_CASE("the state of a search is read as it was written, infinite work and refusals too") {
    const temporary_folder folder;
    const nlohmann::ordered_json setup{{"seed", 7}};
    const double infinite = std::numeric_limits<double>::infinity();
    const search_state state{setup,
                             {{"a@strength=1.5", 0.1, 2.5, 300, 10.5, ""},
                              {"b", 0.2, 1, infinite, infinite, ""},
                              {"c", 0, 0, 0, 0, "it cannot be run"}}};
    write_state(folder / "state.json", state);
    const search_state read = read_state(folder / "state.json", setup);
    CHECK(read.setup == setup);
    REQUIRE(read.trials.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(read.trials[i].candidate == state.trials[i].candidate);
        CHECK(read.trials[i].error == state.trials[i].error);
        CHECK(read.trials[i].milliseconds == state.trials[i].milliseconds);
        CHECK(read.trials[i].instructions == state.trials[i].instructions);
        CHECK(read.trials[i].fetches == state.trials[i].fetches);
        CHECK(read.trials[i].refused == state.trials[i].refused);
    }
}

TEST_CASE("without a file a search begins; a state that is broken or of another search is refused") {
    const temporary_folder folder;
    const nlohmann::ordered_json setup{{"seed", 7}};
    CHECK(read_state(folder / "state.json", setup).trials.empty());
    folder.put("state.json", "{\"version\": 1, \"setup\": {\"seed\": 7}, \"tri");
    CHECK_THROWS_WITH_AS(read_state(folder / "state.json", setup),
                         doctest::Contains("is not the state of a search"), std::runtime_error);
    write_state(folder / "state.json", {setup, {}});
    CHECK_THROWS_WITH_AS(read_state(folder / "state.json", {{"seed", 8}}),
                         doctest::Contains("is of a search over other views"), std::runtime_error);
}
