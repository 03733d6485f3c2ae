// SPDX-License-Identifier: MIT
// Parts that crease does not know compose with those that it does, whatever their role, and what they own is
// there.
#include "own_parts.hpp"
#include "same_effect.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace crease;

/// All parts of crease, and those of the host.
const std::vector<const part*>& known_parts() {
    static const std::vector<const part*> all = [] {
        std::vector<const part*> both(std::begin(all_parts), std::end(all_parts));
        std::apply(
            [&both](const auto&... each) {
                (both.push_back(&std::decay_t<decltype(each)>::part_type::description), ...);
            },
            own::examples);
        return both;
    }();
    return all;
}

bool has_binding(const pass& each, std::string_view name, crease::access how) {
    return std::ranges::any_of(each.bindings,
                               [&](const binding& b) { return b.name == name && b.how == how; });
}

/// Checks that an effect has what a part owns, and that the part's GLSL finds it.
void check_owns(const effect_view& view, std::string_view name) {
    const std::string image = std::string(name) + "_image", making = "make_" + std::string(name);
    CHECK(std::ranges::count(view.resources, std::string_view(image), &resource::name) == 1);
    const auto made = std::ranges::find(view.passes, std::string_view(making), &pass::name);
    REQUIRE(made != view.passes.end());
    CHECK(has_binding(*made, image, crease::access::store));
    CHECK(contains(joined(made->pieces), "vec4(crease_" + std::string(name) + "_tint)"));
    const auto reading = std::ranges::find_if(
        view.passes, [&](const pass& each) { return has_binding(each, image, crease::access::sample); });
    REQUIRE(reading != view.passes.end());
    CHECK(made < reading);
    CHECK(contains(joined(reading->pieces), "crease_" + std::string(name) + "_value()"));

    const auto setting =
        std::ranges::find_if(view.settings, [&](const effect_setting& s) { return s.part == name; });
    REQUIRE(setting != view.settings.end());
    CHECK(setting->name == "tint");
    CHECK(get(view.defaults, view.settings, std::string(name) + ".tint") == 0.5f);
    const std::string member = "    float " + std::string(name) + "_tint;\n";
    for (const pass& each : view.passes)
        if (each.bindings.front().name == "parameters")
            CHECK(contains(each.pieces[0].text, member));
    for (const pass* each : {&*made, &*reading})
        CHECK(contains(each->pieces[0].text, "crease_given." + std::string(name) + "_tint;\n"));
}

}

TEST_CASE("a host's own part of every role composes at compile time and from a recipe alike") {
    std::set<role> roles;
    own::for_each_example([&roles](const auto& each) {
        using effect = typename std::decay_t<decltype(each)>::effect_type;
        roles.insert(std::decay_t<decltype(each)>::part_type::description.kind);
        compared::check_equal_to<effect>(each.recipe, known_parts());
    });
    CHECK(roles.size() == role_count);
}

TEST_CASE("what a host's own part of any role owns is in the effect") {
    own::for_each_example([](const auto& each) {
        using effect = typename std::decay_t<decltype(each)>::effect_type;
        CAPTURE(std::string(each.recipe));
        for (const choice& c : effect::choices)
            if (c.what->name.starts_with("own_")) {
                CAPTURE(std::string(c.what->name));
                check_owns(effect::view(), c.what->name);
            }
    });
}

TEST_CASE("a host's own filter has its steps before the main pass, in the chain and after it") {
    using effect =
        crease::effect<directions<>, single_layer, hbao_plus, bilateral<>, own::own_filter, bilateral<>>;
    const std::string_view names[] = {"make_own_filter", "visibility",  "bilateral_x", "bilateral_y",
                                      "own_filter",      "bilateral_x", "bilateral_y", "count_own_filter"};
    REQUIRE(effect::passes.size() == std::size(names));
    for (std::size_t i = 0; i < std::size(names); ++i)
        CHECK(effect::passes[i].name == names[i]);
    const pass& filtering = effect::passes[4];
    CHECK(has_binding(filtering, "input", crease::access::sample));
    CHECK(has_binding(filtering, "own_filter_image", crease::access::sample));
    CHECK(has_binding(filtering, "output", crease::access::store));
    CHECK(contains(effect::source<4>(), "const int crease_own_filter_twice = 2;\n"));
    for (std::size_t i : {1u, 2u, 3u, 5u, 6u})
        CHECK_FALSE(has_binding(effect::passes[i], "own_filter_image", crease::access::sample));
    const auto count = std::ranges::find(effect::resources, "own_count", &resource::name);
    REQUIRE(count != effect::resources.end());
    CHECK(count->life == lifetime::report);
    CHECK(effect::passes[7].size.fixed_width == 1);
    CHECK(effect::passes[7].group_width() == 8);
    CHECK(effect::passes[7].group_height() == 4);
}

TEST_CASE("two filters of one kind own one image and one setting") {
    using effect = crease::effect<directions<>, single_layer, hbao_plus, own::own_filter, own::own_filter>;
    CHECK(std::ranges::count(effect::resources, std::string_view("own_filter_image"), &resource::name) == 1);
    CHECK(std::ranges::count(effect::settings, std::string_view("own_filter"), &effect_setting::part) == 1);
    CHECK(std::ranges::count(effect::passes, std::string_view("make_own_filter"), &pass::name) == 1);
    CHECK(std::ranges::count(effect::passes, std::string_view("own_filter"), &pass::name) == 2);
}

TEST_CASE("a host's own number is a constant of the program") {
    using fixed = effect<poisson_disk<>, single_layer, own::own_estimator, bilateral<>>;
    static_assert(contains(fixed::passes[1].pieces[0].text, "const int crease_own_estimator_most = 20;\n"));
    CHECK(contains(fixed::source<1>(), "float(crease_own_estimator_most)"));
}

TEST_CASE("a host's own estimator is refused beside a sampler that does not fit") {
    CHECK(recipe("hemisphere_points/single_layer/own_estimator", known_parts()).error() ==
          "crease::effect: taps on the screen are needed, which the sampler does not propose "
          "(own_estimator, hemisphere_points)");
}
