// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace {

using namespace crease;

constexpr choice legal[] = {choice_of<directions<>>(), choice_of<single_layer>(), choice_of<hbao>()};
static_assert(!check(legal));
static_assert(complete(legal).size() == 14);
static_assert(complete(legal)[3].what == &perspective::description);

constexpr choice unordered[] = {choice_of<poisson_disk<>>(), choice_of<single_layer>(), choice_of<hbao>()};
static_assert(check(unordered).first == "hbao");
static_assert(check(unordered).second == "poisson_disk");
static_assert(check(unordered).message().view() ==
              "crease::effect: the estimator needs taps in order along directions, which the sampler does "
              "not propose (hbao, poisson_disk)");

/// A filter that reads pixels of the picture, and makes it from a smaller one.
constexpr step whole[] = {
    {.name = "zoom", .files = bilateral_part::files, .full_size_input = true, .upsampling = 0}};
constexpr part zoom{.kind = role::filter,
                    .name = "zoom",
                    .summary = "",
                    .source = "",
                    .numbers = upsample<>::takes,
                    .steps = whole};
constexpr choice zoomed[] = {
    choice_of<directions<>>(), choice_of<single_layer>(), choice_of<hbao>(), {&zoom, {2}}};
static_assert(check(zoomed).first == "zoom");

/// The default part of a role; null where the effect has none.
const part* default_of(const choice_list& all, role wanted) {
    for (const choice& each : all)
        if (each.what->kind == wanted)
            return each.what;
    return nullptr;
}

}

TEST_CASE("no choice at all is refused") {
    CHECK(check({}).message().view() == "crease::effect: the first part must be a sampler (there is none)");
}

TEST_CASE("a choice is not completed with a part whose role is taken") {
    std::vector<choice> chosen(std::begin(legal), std::end(legal));
    chosen.push_back(choice_of<orthographic>());
    const choice_list all = complete(chosen);
    CHECK(all.size() == 14);
    for (const choice& each : all)
        CHECK(each.what != &perspective::description);
}

TEST_CASE("of a role the first part that fits is the default, and none where no other part requires it") {
    const choice_list flat = complete(legal);
    CHECK(default_of(flat, role::layer_traversal) == &all_layers::description);
    CHECK(default_of(flat, role::receivers) == &first_surface::description);
    CHECK(default_of(flat, role::image_reads) == &texel_fetch::description);
    for (role r : {role::coverage, role::layer_storage, role::scan, role::further_views, role::filter})
        CHECK(default_of(flat, r) == nullptr);
    const choice_list layered = complete(recipe("directions/stochastic_layers/hbao").choices());
    CHECK(default_of(layered, role::coverage) == &stratified::description);
    CHECK(default_of(layered, role::layer_storage) == &multisampled_part::description);
    const choice_list areas = complete(recipe("sample_box/summed_area/mean_height").choices());
    CHECK(default_of(areas, role::layer_traversal) == &area_layers::description);
    CHECK(default_of(areas, role::scan) == &work_efficient_scan::description);
    CHECK(default_of(complete(recipe("sample_box/mip_chain/mean_height").choices()), role::scan) == nullptr);
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
