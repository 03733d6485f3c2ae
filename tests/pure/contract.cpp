// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace {

using namespace crease;

constexpr choice legal[] = {choice_of<directions<>>(), choice_of<single_layer>(), choice_of<hbao>()};
static_assert(!check(legal));
static_assert(complete(legal).size() == 10);
static_assert(complete(legal)[3].what == &perspective::description);

constexpr choice unordered[] = {choice_of<poisson_disk<>>(), choice_of<single_layer>(), choice_of<hbao>()};
static_assert(check(unordered).first == "hbao");
static_assert(check(unordered).second == "poisson_disk");
static_assert(check(unordered).message().view() ==
              "crease::effect: the estimator needs taps in order along directions, which the sampler does "
              "not propose (hbao, poisson_disk)");

/// A filter that reads pixels of the picture, and makes it from a smaller one.
constexpr step whole[] = {{.name = "zoom", .body = &bilateral_glsl, .full_size_input = true}};
constexpr part zoom{.kind = role::filter,
                    .name = "zoom",
                    .summary = "",
                    .source = "",
                    .numbers = upsample<>::takes,
                    .steps = whole,
                    .upsampling = 0};
constexpr choice zoomed[] = {
    choice_of<directions<>>(), choice_of<single_layer>(), choice_of<hbao>(), {&zoom, {2}}};
static_assert(check(zoomed).first == "zoom");

}

TEST_CASE("no choice at all is refused") {
    CHECK(check({}).message().view() == "crease::effect: the first part must be a sampler (there is none)");
}

TEST_CASE("a choice is not completed with a part whose role is taken") {
    std::vector<choice> chosen(std::begin(legal), std::end(legal));
    chosen.push_back(choice_of<orthographic>());
    const choice_list all = complete(chosen);
    CHECK(all.size() == 10);
    for (const choice& each : all)
        CHECK(each.what != &perspective::description);
}

TEST_CASE("every number is checked at both ends of its range") {
    for (const part* each : all_parts)
        for (std::size_t i = 0; i < each->numbers.size(); ++i) {
            CAPTURE(std::string(each->name));
            choice c{each, {}};
            for (std::size_t j = 0; j < each->numbers.size(); ++j)
                c.numbers[j] = each->numbers[j].fallback;
            const auto accepts = [&](int value) {
                c.numbers[i] = value;
                return rules::numbers_in_range(c);
            };
            CHECK(accepts(each->numbers[i].least));
            CHECK(accepts(each->numbers[i].most));
            CHECK_FALSE(accepts(each->numbers[i].least - 1));
            CHECK_FALSE(accepts(each->numbers[i].most + 1));
        }
}
