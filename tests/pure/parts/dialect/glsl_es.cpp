// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <string>

namespace {

using namespace crease;
using of_webgl = effect<directions<>, single_layer, hbao, bilateral<>, fragment, glsl_es<300>>;
using of_es_31 = effect<directions<>, single_layer, hbao, bilateral<>, glsl_es<>>;

constexpr format texels_of(const effect_view& effect, std::string_view name) {
    for (const resource& r : effect.resources)
        if (r.name == name)
            return r.texels;
    return format::none;
}
static_assert(texels_of(of_webgl::view(), "visibility") == format::r8_unorm);
static_assert(texels_of(of_webgl::view(), "between_0") == format::r32_uint ||
              texels_of(of_webgl::view(), "between_0") == format::rg32_uint);
static_assert(texels_of(of_es_31::view(), "visibility") == format::rgba8_unorm);

std::string error_of(std::string_view text) {
    return std::string(recipe(text).error());
}

}

TEST_CASE("version 300 of glsl_es has no bindings, version 310 has") {
    const std::string_view webgl = of_webgl::source<0>(), es = of_es_31::source<0>();
    CHECK(webgl.starts_with("#version 300 es\n// "));
    CHECK(es.starts_with("#version 310 es\n// "));
    CHECK(contains(webgl, "precision highp float;\nprecision highp int;\n"));
    CHECK(contains(webgl, "\nuniform highp sampler2D crease_depth;\n"));
    CHECK(contains(es, "\nlayout(binding = 0) uniform highp sampler2D crease_depth;\n"));
    CHECK(contains(webgl, "layout(std140) uniform crease_parameters {"));
    CHECK(of_webgl::passes[0].dialect == dialect_kind::glsl_es);
    CHECK(contains(of_webgl::passes[0].vertex_pieces[0].text, "#version 300 es\n"));
}

TEST_CASE("no global of glsl_es begins with what is uniform") {
    for (const std::string_view text : {of_webgl::source<0>(), of_es_31::source<0>()}) {
        CHECK(contains(text, "#define crease_radius crease_given.radius\n"));
        CHECK(contains(text, "#define crease_hbao_bias crease_given.hbao_bias\n"));
        CHECK(contains(text, "\ncrease_view_parameters crease_view;"));
        CHECK(contains(text, "\nvoid main() {\n    crease_view = crease_view_of(crease_view_index);\n"));
    }
    using functions_of_webgl = effect<directions<>, single_layer, hbao, functions<>, glsl_es<300>>;
    CHECK(contains(
        functions_of_webgl::source<0>(),
        "float crease_visibility(ivec2 pixel) {\n    crease_view = crease_view_of(crease_view_index);\n"));
}

TEST_CASE("version 300 of glsl_es counts bits itself") {
    constexpr std::string_view bitmask = "slices/single_layer/visibility_bitmask/fragment/glsl_es:";
    const auto text_of = [&](const char* which) {
        const auto composed = std::make_unique<composition>(recipe(std::string(bitmask) + which));
        return joined(composed->view().passes[0].pieces);
    };
    CHECK(contains(text_of("300"), "int crease_bit_count(uint bits) {\n    bits -= "));
    CHECK(contains(text_of("310"), "return bitCount(int(bits));"));
}

TEST_CASE("what glsl_es cannot is refused by name") {
    CHECK(error_of("directions/single_layer/hbao/glsl_es:305") ==
          "crease::effect: the versions of GLSL ES are 300 and 310 (glsl_es)");
    CHECK(error_of("directions/single_layer/hbao/glsl_es:300") ==
          "crease::effect: GLSL ES 3.00 has fragment shaders alone, and a part needs others (compute, "
          "glsl_es)");
    CHECK(
        contains(error_of("directions/depth_pyramid/hbao/fragment/glsl_es:300"), "(depth_pyramid, glsl_es)"));
    CHECK(contains(error_of("directions/single_layer/hbao/linearised_depth/fragment/glsl_es:300"),
                   "(linearised_depth, glsl_es)"));
    CHECK(error_of("directions/stochastic_layers/hbao/glsl_es:310") ==
          "crease::effect: GLSL ES and WebGPU have no way to capture layers, which a part needs "
          "(multisampled, glsl_es)");
    CHECK(error_of("directions/single_layer/hbao/bilateral/image_load/fragment/glsl_es:300") ==
          "crease::effect: GLSL ES 3.00 has no storage images, which a part loads (image_load, glsl_es)");
    CHECK(error_of("box_area/summed_area/unsharp_mask/subgroup_scan/glsl_es") ==
          "crease::effect: GLSL ES and WebGPU promise no operations of subgroups, which a part needs "
          "(subgroup_scan, glsl_es)");
    CHECK(recipe("directions/depth_pyramid/hbao/glsl_es"));
}
