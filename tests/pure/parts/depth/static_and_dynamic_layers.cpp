// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

using two = effect<directions<2, 4>, static_and_dynamic_layers<1, 3, 20>, hbao>;
static_assert(offers<static_and_dynamic_layers<>, depth_layers>);
static_assert(offers<static_and_dynamic_layers<>, layers_behind_front>);
static_assert(!offers<static_and_dynamic_layers<>, layers_of_two_views>);
static_assert(offers<static_and_dynamic_layers<>, layers_with_opacity>);
static_assert(offers<static_and_dynamic_layers<>, layers_with_normals>);
using with_opacity = effect<directions<2, 4>, static_and_dynamic_layers<1, 3, 20>, hbao, every_layer>;
static_assert(with_opacity::passes.size() == 6);
static_assert(two::passes.size() == 4);

template <class Effect>
const resource& named(std::string_view name) {
    return *std::ranges::find(Effect::resources, name, &resource::name);
}

}

TEST_CASE("static and dynamic geometry have a geometry pass and a layer each") {
    constexpr std::string_view names[] = {"capture_static", "capture_dynamic"};
    for (std::size_t i = 0; i < 2; ++i) {
        CAPTURE(i);
        const pass& each = two::passes[i];
        CHECK(each.name == names[i]);
        CHECK(each.stage == stage_kind::geometry);
        CHECK(each.bindings[1].set == 1);
        CHECK(each.bindings[1].slot == 4);
    }
    CHECK(two::passes[2].name == "pack_layers");
    CHECK(named<two>("fragment_layers").layers == 2);
    CHECK(named<two>("packed_layers").layers == 1);
    CHECK(named<two>("packed_layers").texels == format::rg32_float);
}

TEST_CASE("each has a pass for its surfaces, and two layers of all that belongs to them") {
    constexpr std::string_view names[] = {"capture_static", "capture_dynamic", "capture_static_surfaces",
                                          "capture_dynamic_surfaces", "pack_layers"};
    for (std::size_t i = 0; i < 5; ++i) {
        CAPTURE(i);
        const pass& each = with_opacity::passes[i];
        CHECK(each.name == names[i]);
        CHECK(each.takes_surfaces == (i < 4));
        if (i < 4)
            CHECK(contains(joined(each.pieces), i % 2 == 0 ? "layers_index = 0;" : "layers_index = 1;"));
    }
    CHECK(named<with_opacity>("fragment_layers").layers == 2);
    CHECK(named<with_opacity>("fragment_surfaces").layers == 4);
    CHECK(named<with_opacity>("layer_surfaces").layers == 2);
    CHECK(named<with_opacity>("packed_opacities").layers == 1);
    CHECK(named<with_opacity>("packed_layers").texels == format::rgba32_float);
}
