// SPDX-License-Identifier: MIT
#include <crease/parts.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

namespace {

struct no_part {};

static_assert(crease::a_part<crease::hbao>);
static_assert(!crease::a_part<no_part>);
static_assert(!crease::a_part<int>);
static_assert(crease::choice_of<crease::directions<6, 3>>().numbers[0] == 6);
static_assert(crease::choice_of<crease::directions<6, 3>>().numbers[1] == 3);
static_assert(crease::choice_of<crease::hbao>().what == &crease::hbao::description);
static_assert(crease::offers<crease::directions<>, crease::ordered_taps>);
static_assert(!crease::offers<crease::poisson_disk<>, crease::ordered_taps>);
static_assert(crease::name_of(crease::role::dialect) == "dialect");

}

TEST_CASE("each part is described in full") {
    std::set<std::string> names;
    for (const crease::part* each : crease::all_parts) {
        CAPTURE(std::string(each->name));
        CHECK(names.emplace(each->name).second);
        CHECK_FALSE(each->summary.empty());
        CHECK(each->numbers.size() <= crease::most_numbers);
        for (const crease::number& number : each->numbers) {
            CHECK(number.least <= number.fallback);
            CHECK(number.fallback <= number.most);
            CHECK_FALSE(number.meaning.empty());
        }
        for (const crease::setting& setting : each->settings) {
            CHECK(setting.least <= setting.fallback);
            CHECK(setting.fallback <= setting.most);
            CHECK_FALSE(setting.meaning.empty());
        }
    }
}

TEST_CASE("a part's GLSL has the part's stem and no fence") {
    for (const crease::part* each : crease::all_parts) {
        CAPTURE(std::string(each->name));
        if (!each->glsl)
            continue;
        const std::size_t slash = each->glsl->name.find('/');
        REQUIRE(slash != std::string_view::npos);
        CHECK(each->glsl->name.substr(slash + 1) == std::string(each->name).append(".glsl"));
        CHECK(each->glsl->text.starts_with("// SPDX-License-Identifier: MIT\n"));
        CHECK(each->glsl->text.ends_with("\n"));
        CHECK_FALSE(contains(each->glsl->text, "__cplusplus"));
    }
}
