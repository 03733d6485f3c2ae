// SPDX-License-Identifier: MIT
#include <crease/parts/all_parts.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <map>
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

/// Calls `action` with each GLSL file of a part.
template <class Action>
void for_each_file(const crease::part& p, Action action) {
    for (const crease::glsl_file* file : p.files)
        action(*file);
    for (const crease::glsl_file* file : p.main_files)
        action(*file);
    for (const crease::step& step : p.steps)
        for (const crease::glsl_file* file : step.files)
            action(*file);
}

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

TEST_CASE("a part's GLSL has the part's stem") {
    // Parts without GLSL of their own, or whose name in a recipe is another.
    const std::set<std::string_view> others{"texel_fetch",
                                            "image_load",
                                            "vulkan",
                                            "webgpu",
                                            "opengl",
                                            "glsl_es",
                                            "second_view",
                                            "further_views",
                                            "centred_samples",
                                            "packed_bent_cone",
                                            "r8",
                                            "rgba8",
                                            "r32f",
                                            "world_normals",
                                            "packed_world_normals",
                                            "octahedral_world_normals"};
    for (const crease::part* each : crease::all_parts) {
        CAPTURE(std::string(each->name));
        bool is_there = others.contains(each->name);
        for_each_file(*each, [&](const crease::glsl_file& file) {
            is_there = is_there || file.name.ends_with("/" + std::string(each->name) + ".glsl");
        });
        CHECK(is_there);
    }
}

TEST_CASE("a part's GLSL has no fence, and a file the same name everywhere") {
    std::map<std::string_view, const crease::glsl_file*> known;
    for (const crease::part* each : crease::all_parts)
        for_each_file(*each, [&](const crease::glsl_file& file) {
            CAPTURE(std::string(file.name));
            CHECK(file.text.ends_with("\n"));
            CHECK_FALSE(contains(file.text, "__cplusplus"));
            CHECK_FALSE(contains(file.text, "SPDX"));
            CHECK(known.emplace(file.name, &file).first->second == &file);
        });
}

TEST_CASE("every role has a part, and a name of its own") {
    std::set<crease::role> seen;
    std::set<std::string_view> names;
    for (const crease::part* each : crease::all_parts)
        seen.insert(each->kind);
    CHECK(seen.size() == crease::role_count);
    for (std::size_t i = 0; i < crease::role_count; ++i)
        CHECK(names.insert(crease::name_of(static_cast<crease::role>(i))).second);
}
