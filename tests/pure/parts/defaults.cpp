// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <algorithm>

using namespace crease;

TEST_CASE("every role that need not be named has a default, and of those that fit the first is taken") {
    for (std::size_t r = 0; r < role_count; ++r) {
        const role kind = static_cast<role>(r);
        CAPTURE(name_of(kind));
        const bool named = kind == role::sampler || kind == role::depth_source || kind == role::estimator ||
                           kind == role::filter || kind == role::further_views ||
                           kind == role::layer_compression || kind == role::resolutions;
        const bool has_two = kind == role::layer_traversal || kind == role::receivers;
        const auto count =
            std::ranges::count(default_choices, kind, [](const choice& c) { return c.what->kind; });
        CHECK(count == (named ? 0 : has_two ? 2 : 1));
    }
}

TEST_CASE("the defaults of an effect are those that its parts let in") {
    const auto traversal_of = [](std::string_view text) {
        const choice_list all = complete(recipe(text).choices());
        const auto found =
            std::ranges::find(all, role::layer_traversal, [](const choice& c) { return c.what->kind; });
        return found == all.end() ? "none" : found->what->name;
    };
    CHECK(traversal_of("directions/single_layer/hbao") == "all_layers");
    CHECK(traversal_of("sample_box/summed_area/mean_height") == "area_layers");
    CHECK(traversal_of("directions/stochastic_layers/hbao/front_first") == "front_first");
}

TEST_CASE("what only serves what another part requires is not there by default") {
    const auto has_role = [](std::string_view text, role wanted) {
        const choice_list all = complete(recipe(text).choices());
        return std::ranges::any_of(all, [wanted](const choice& c) { return c.what->kind == wanted; });
    };
    for (role r : {role::coverage, role::layer_storage, role::scan})
        CHECK_FALSE(has_role("directions/single_layer/hbao", r));
    CHECK(has_role("directions/stochastic_layers/hbao", role::coverage));
    CHECK(has_role("directions/stochastic_layers/hbao", role::layer_storage));
    CHECK(has_role("sample_box/summed_area/mean_height", role::scan));
}
