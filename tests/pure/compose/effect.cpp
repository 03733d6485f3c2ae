// SPDX-License-Identifier: MIT
#include "same_effect.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;
using compared::check_equal_to;

using plain = effect<directions<8, 4>, single_layer, hbao>;
static_assert(plain::passes.size() == 1);
static_assert(plain::passes[0].name == "visibility");
static_assert(plain::passes[0].group_width() == 16);
static_assert(plain::resources.size() == 4);
static_assert(plain::settings.size() == 4);
static_assert(plain::settings[0].part == "hbao" && plain::settings[0].name == "bias");
static_assert(plain::features.extended_storage_formats);
static_assert(get(plain::defaults, plain::settings, "bias") == hbao::reads[0].fallback);
static_assert(has_version(plain::passes[0].pieces[0].text, "#version 450\n"));
static_assert(
    plain::passes[0].pieces[0].text.starts_with("// directions:8x4x2/single_layer/hbao, pass visibility; "
                                                "crease 0.2.0, SPDX-License-Identifier: MIT-0\n"));
static_assert(plain::view().block_size() == block_size(1, 4));
static_assert(plain::view().recipe == "directions:8x4x2/single_layer/hbao");
static_assert(plain::passes[0].spirv.empty() && plain::passes[0].vertex_spirv.empty());

static_assert(!effect<directions<8, 4>, single_layer, hbao, fragment>::features.extended_storage_formats);
static_assert(!effect<directions<8, 4>, single_layer, hbao, opengl_glsl>::features.extended_storage_formats);

}

TEST_CASE("the text of a pass is joined once, and ends with a NUL") {
    const std::string_view text = plain::source<0>();
    CHECK(text.size() > 1000);
    CHECK(text.data() == plain::source<0>().data());
    CHECK(text == joined(plain::passes[0].pieces));
    CHECK(text.data()[text.size()] == '\0');
}

TEST_CASE("an effect and the recipe of its parts are equal to the byte") {
    check_equal_to<effect<directions<8, 4>, single_layer, hbao>>("directions:8x4/single_layer/hbao");
    check_equal_to<effect<directions<6, 6>, single_layer, hbao_plus>>(
        "directions:6x6/single_layer/hbao_plus");
    check_equal_to<effect<hemisphere_points<>, single_layer, ssao>>("hemisphere_points/single_layer/ssao");
    check_equal_to<effect<poisson_disk<9>, single_layer, hbao_plus>>("poisson_disk:9/single_layer/hbao_plus");
    check_equal_to<effect<directions<>, single_layer, hbao, bilateral<>>>(
        "directions/single_layer/hbao/bilateral");
    check_equal_to<effect<directions<>, single_layer, hbao, bilateral<2>, upsample<4>, fragment>>(
        "directions/single_layer/hbao/bilateral:2/upsample:4/fragment");
    check_equal_to<effect<hemisphere_points<>, single_layer, ssao, upsample<>, bilateral<>, opengl_glsl>>(
        "hemisphere_points/single_layer/ssao/upsample/bilateral/opengl");
    check_equal_to<effect<poisson_disk<>, single_layer, hbao_plus, fragment, opengl_glsl>>(
        "poisson_disk/single_layer/hbao_plus/fragment/opengl");
    check_equal_to<
        effect<directions<>, single_layer, hbao, orthographic, linear_depth, reconstructed_normals>>(
        "directions/single_layer/hbao/orthographic/linear_depth/reconstructed_normals");
    check_equal_to<effect<directions<>, single_layer, hbao, fragment, linearised_depth, image_load>>(
        "directions/single_layer/hbao/fragment/linearised_depth/image_load");
    check_equal_to<effect<directions<>, single_layer, hbao, functions<1, 3, 20>>>(
        "directions/single_layer/hbao/functions:1x3x20");
    check_equal_to<effect<hemisphere_points<>, single_layer, ssao, functions<0, 2>, opengl_glsl>>(
        "hemisphere_points/single_layer/ssao/functions:0x2/opengl");
    check_equal_to<
        effect<directions<>, single_layer, hbao_plus, compute<8, 8>, reconstructed_normals, bilateral<16>>>(
        "directions/single_layer/hbao_plus/compute:8x8/reconstructed_normals/bilateral:16");
}

TEST_CASE("so are those with geometry passes, tables and cameras") {
    check_equal_to<
        effect<directions<4, 4>, stochastic_layers<6>, hbao, atomic_minimum<1, 2, 3>, simple_hash>>(
        "directions:4x4/stochastic_layers:6/hbao/atomic_minimum:1x2x3/simple_hash");
    check_equal_to<effect<directions<>, stochastic_layers<>, hbao_plus, second_view<>, bent_cone>>(
        "directions/stochastic_layers/hbao_plus/second_view/bent_cone");
    check_equal_to<effect<directions<>, stochastic_layers<>, hbao, deferred_layers<>, centred_samples<>>>(
        "directions/stochastic_layers/hbao/deferred_layers/centred_samples");
    check_equal_to<effect<sample_box, summed_area_adaptive<8, 2>, mean_height<>, subgroup_scan>>(
        "sample_box/summed_area_adaptive:8x2/mean_height/subgroup_scan");
}
