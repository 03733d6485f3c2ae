// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace {

using namespace crease;

using plain = effect<directions<8, 4>, single_layer, hbao>;
static_assert(plain::passes.size() == 1);
static_assert(plain::passes[0].name == "visibility");
static_assert(plain::passes[0].group_width() == 16);
static_assert(plain::resources.size() == 4);
static_assert(plain::features.extended_storage_formats);
static_assert(plain::defaults.bias == hbao::reads[0].fallback);
static_assert(plain::passes[0].pieces[0].text.starts_with("#version 450\n"));
static_assert(plain::source<0>.size() > 1000);

static_assert(!effect<directions<8, 4>, single_layer, hbao, fragment>::features.extended_storage_formats);
static_assert(!effect<directions<8, 4>, single_layer, hbao, opengl_glsl>::features.extended_storage_formats);

constexpr device_features all_of_them{.extended_storage_formats = true};
static_assert(all_of_them.cover(plain::features));
static_assert(!device_features{}.cover(plain::features));

bool same(const binding& a, const binding& b) {
    return a.name == b.name && a.resource == b.resource && a.how == b.how && a.set == b.set &&
           a.slot == b.slot;
}

bool same(const constant& a, const constant& b) {
    return a.part == b.part && a.number == b.number && a.id == b.id && a.value == b.value;
}

bool same(const resource& a, const resource& b) {
    return a.name == b.name && a.texels == b.texels && a.life == b.life && a.size == b.size &&
           a.layers == b.layers && a.samples == b.samples && a.arrayed == b.arrayed && a.fill == b.fill &&
           a.count == b.count;
}

template <class Item>
bool all_same(array_view<const Item> one, array_view<const Item> other) {
    return std::ranges::equal(one, other, [](const Item& a, const Item& b) { return same(a, b); });
}

void check_equal(const pass& fixed, const pass& chosen) {
    CHECK(fixed.name == chosen.name);
    CHECK(fixed.stage == chosen.stage);
    CHECK(fixed.dialect == chosen.dialect);
    CHECK(fixed.size == chosen.size);
    CHECK(all_same(fixed.bindings, chosen.bindings));
    CHECK(all_same(fixed.constants, chosen.constants));
    CHECK(joined(fixed.pieces) == joined(chosen.pieces));
    CHECK(joined(fixed.vertex_pieces) == joined(chosen.vertex_pieces));
    REQUIRE(fixed.pieces.size() == chosen.pieces.size());
    for (std::size_t i = 0; i < fixed.pieces.size(); ++i)
        CHECK(fixed.pieces[i].name == chosen.pieces[i].name);
}

template <class Effect, std::size_t... Pass>
void check_sources(std::index_sequence<Pass...>) {
    const std::string_view sources[] = {Effect::template source<Pass>...};
    for (std::size_t i = 0; i < sizeof...(Pass); ++i) {
        CHECK(joined(Effect::passes[i].pieces) == sources[i]);
        CHECK(sources[i].data()[sources[i].size()] == '\0');
    }
}

template <class... Parts>
void check_equal_to(std::string_view text) {
    using fixed = effect<Parts...>;
    CAPTURE(std::string(text));
    const recipe chosen(text);
    REQUIRE(chosen);
    const auto composed = std::make_unique<composition>(chosen);
    const effect_view view = composed->view();
    CHECK(view.defaults == fixed::defaults);
    CHECK(view.features == fixed::features);
    CHECK(all_same<resource>(fixed::resources, view.resources));
    REQUIRE(view.passes.size() == fixed::passes.size());
    for (std::size_t i = 0; i < view.passes.size(); ++i)
        check_equal(fixed::passes[i], view.passes[i]);
    check_sources<fixed>(std::make_index_sequence<fixed::passes.size()>{});
}

}

TEST_CASE("an effect and the recipe of its parts are equal to the byte") {
    check_equal_to<directions<8, 4>, single_layer, hbao>("directions:8x4/single_layer/hbao");
    check_equal_to<directions<6, 6>, single_layer, hbao_plus>("directions:6x6/single_layer/hbao_plus");
    check_equal_to<hemisphere_points<>, single_layer, ssao>("hemisphere_points/single_layer/ssao");
    check_equal_to<poisson_disk<9>, single_layer, hbao_plus>("poisson_disk:9/single_layer/hbao_plus");
    check_equal_to<directions<>, single_layer, hbao, bilateral<>>("directions/single_layer/hbao/bilateral");
    check_equal_to<directions<>, single_layer, hbao, bilateral<2>, upsample<4>, fragment>(
        "directions/single_layer/hbao/bilateral:2/upsample:4/fragment");
    check_equal_to<hemisphere_points<>, single_layer, ssao, upsample<>, bilateral<>, opengl_glsl>(
        "hemisphere_points/single_layer/ssao/upsample/bilateral/opengl");
    check_equal_to<poisson_disk<>, single_layer, hbao_plus, fragment, opengl_glsl>(
        "poisson_disk/single_layer/hbao_plus/fragment/opengl");
    check_equal_to<directions<>, single_layer, hbao, orthographic, linear_depth, reconstructed_normals>(
        "directions/single_layer/hbao/orthographic/linear_depth/reconstructed_normals");
    check_equal_to<directions<>, single_layer, hbao, fragment, linearised_depth>(
        "directions/single_layer/hbao/fragment/linearised_depth");
    check_equal_to<directions<>, single_layer, hbao, functions<1, 3, 20>>(
        "directions/single_layer/hbao/functions:1x3x20");
    check_equal_to<hemisphere_points<>, single_layer, ssao, functions<0, 2>, opengl_glsl>(
        "hemisphere_points/single_layer/ssao/functions:0x2/opengl");
    check_equal_to<directions<>, single_layer, hbao_plus, compute<8, 8>, reconstructed_normals,
                   bilateral<16>>(
        "directions/single_layer/hbao_plus/compute:8x8/reconstructed_normals/bilateral:16");
}
