// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using by_default = effect<sample_box, summed_area<>, mean_height<>>;
using chosen = effect<sample_box, summed_area<>, mean_height<>, subgroup_scan>;
using in_opengl = effect<sample_box, summed_area<>, mean_height<>, subgroup_scan, opengl_glsl>;

static_assert(chosen::features.subgroup_arithmetic && in_opengl::features.subgroup_arithmetic);
static_assert(!by_default::features.subgroup_arithmetic);
static_assert(!device_features{}.cover(chosen::features) && chosen::features.cover(by_default::features));

constexpr std::string_view extension = "#extension GL_KHR_shader_subgroup_arithmetic : require\n";

}

TEST_CASE("subgroup_scan takes the place of the other scan, and its extension stands where its text does") {
    for (std::size_t i = 0; i < chosen::passes.size(); ++i) {
        const bool sums = i == 2 || i == 3;
        CAPTURE(i);
        CHECK(contains(chosen::passes[i].pieces[0].text, extension) == sums);
        CHECK(contains(in_opengl::passes[i].pieces[0].text, extension) == sums);
        CHECK_FALSE(contains(by_default::passes[i].pieces[0].text, extension));
        if (sums) {
            CHECK(has_part_of(chosen::passes[i], "scan/subgroup_scan.glsl"));
            CHECK_FALSE(has_part_of(chosen::passes[i], "scan/work_efficient_scan.glsl"));
        }
    }
}
