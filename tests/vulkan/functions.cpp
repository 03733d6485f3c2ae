// SPDX-License-Identifier: MIT
// The stage `functions`, in a host's own shader that runs.
#include <crease/vulkan/runner.hpp>

#include "hosted_effect.hpp"
#include "small_corner.hpp"
#include "validated_device.hpp"

#include <algorithm>

using namespace crease;

namespace {

constexpr piece host{"host", R"(#version 450
layout(local_size_x = 8, local_size_y = 4, local_size_x_id = 0, local_size_y_id = 1) in;
layout(set = 0, binding = 0, r8) writeonly uniform image2D crease_output;
)"};

std::vector<float> run(const effect_view& effect) {
    vulkan::runner runner(validated_device(), effect, small_corner::width, small_corner::height);
    runner.upload("depth", small_corner::device_depth());
    runner.run(small_corner::parameters_for(effect));
    return runner.download("visibility");
}

}

TEST_CASE("a host's shader around functions gives the picture of the stage compute") {
    for (const char* parts :
         {"directions:6x4/single_layer/hbao", "hemisphere_points:9/single_layer/ssao",
          "poisson_disk:9/single_layer/hbao_plus/linearised_depth", "sample_box/summed_area:2/mean_height"}) {
        CAPTURE(std::string(parts));
        const std::string text = std::string(parts) + "/reconstructed_normals";
        const composition computed{recipe(std::string_view(text))};
        const std::vector<float> expected = run(computed.view());
        CHECK(std::ranges::min(expected) < 0.8f); // the corner is dark, and the open floor is not
        CHECK(std::ranges::max(expected) > 0.98f);
        for (const char* places : {"/functions:0x1x2", "/functions:2x5x40"}) {
            CAPTURE(std::string(places));
            const hosted_effect hosted(text + places, host);
            CHECK(small_corner::largest_difference(run(hosted.view()), expected) <= small_corner::a_step);
        }
    }
    CHECK_NOTHROW(validated_device().check_messages());
}
