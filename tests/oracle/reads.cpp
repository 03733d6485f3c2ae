// SPDX-License-Identifier: MIT
// How passes read what passes write is a choice of its own: by texel fetches or by image loads, the picture
// is the same.
#include "captured.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using oracle::lens;

/// Whether any pass of an effect loads from an image.
bool loads(const crease::effect_view& effect) {
    return std::ranges::any_of(effect.passes, [](const crease::pass& each) {
        return std::ranges::any_of(each.bindings,
                                   [](const crease::binding& b) { return b.how == crease::access::load; });
    });
}

/// The visibility where the samples of the layers, if there are any, share out those of the picture.
std::vector<float> seen(const oracle::picture& p, const crease::effect_view& effect, unsigned samples) {
    const given_layers given(effect);
    crease::vulkan::runner runner(oracle::device(), given, static_cast<unsigned>(p.width),
                                  static_cast<unsigned>(p.height));
    oracle::upload(runner, given, p);
    if (samples > 0)
        runner.upload("captured_layers", oracle::share_out(p, samples));
    runner.run(oracle::view_parameters(p, effect, 0.8));
    return runner.download("visibility");
}

}

TEST_CASE("texel fetches and image loads give the same picture") {
    struct example {
        const char* recipe;
        unsigned samples;
    };
    const oracle::picture p = oracle::many_layers(lens::standard, 97, 61, 16);
    for (const example& of :
         {example{"directions:6x3/single_layer/hbao/bilateral:2/upsample:2", 0},
          {"hemisphere_points:9/single_layer/ssao/bilateral:2/fragment", 0},
          {"directions:6x3/single_layer/hbao_plus/linearised_depth", 0},
          {"sample_box/summed_area:2/mean_height", 0},
          {"sample_box/summed_area_adaptive:4/mean_height", 0},
          {"directions:6x4/stochastic_layers:16/hbao/atomic_minimum", 16},
          {"directions:6x4/stochastic_layers:16/hbao_plus/atomic_minimum/front_first", 16}}) {
        CAPTURE(std::string(of.recipe));
        const auto fetching = oracle::compose(of.recipe),
                   named = oracle::compose(std::string(of.recipe) + "/texel_fetch"),
                   loading = oracle::compose(std::string(of.recipe) + "/image_load");
        CHECK(!loads(*fetching)); // the default
        CHECK(!loads(*named));
        CHECK(loads(*loading));
        const std::vector<float> picture = seen(p, *fetching, of.samples);
        CHECK(*std::ranges::min_element(picture) < 0.8f);
        CHECK(seen(p, *loading, of.samples) == picture);
    }
}
