// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using effect_with_filter = effect<directions<>, single_layer, hbao, bilateral<>, packed_bent_cone>;
static_assert(effect_with_filter::resources.back().name == "packed_bent_cone");
static_assert(effect_with_filter::resources.back().texels == format::rgba8_unorm);

bool is_there(std::string_view name) {
    for (const resource& each : effect_with_filter::resources)
        if (each.name == name)
            return true;
    return false;
}

}

TEST_CASE("a packed bent cone leaves in one image that every device can store") {
    CHECK(is_there("packed_bent_cone"));
    CHECK_FALSE(is_there("visibility"));
    using alone = effect<directions<>, single_layer, hbao, packed_bent_cone>;
    CHECK_FALSE(alone::features.extended_storage_formats);
    CHECK(contains(alone::source<0>(), "rgba8"));
    CHECK_FALSE(has_part_of(alone::passes[0], "encoding/visibility_depth_cone.glsl"));
}

TEST_CASE("the octahedron stands once, also where the result is read and written") {
    const std::string_view last = effect_with_filter::source<2>();
    const std::size_t at = last.find("vec2 crease_octahedron(vec3 direction) {");
    REQUIRE(at != std::string_view::npos);
    CHECK(last.find("vec2 crease_octahedron(vec3 direction) {", at + 1) == std::string_view::npos);
}
