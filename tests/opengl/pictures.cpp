// SPDX-License-Identifier: MIT
// What programs for OpenGL make is what those for Vulkan make of the same depth.
#include "host.hpp"
#include "hosted_effect.hpp"
#include "small_corner.hpp"

#include <crease/vulkan/runner.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace crease;

namespace {

constexpr piece functions_host{"host", R"(#version 430
layout(local_size_x = 8, local_size_y = 4) in;
layout(r8, binding = 0) writeonly uniform image2D crease_output;
)"};

std::vector<float> by_vulkan(const effect_view& effect, std::string_view image) {
    static vulkan::device device({.name = {}, .validation = true});
    vulkan::runner runner(device, effect, small_corner::width, small_corner::height);
    runner.upload("depth", small_corner::device_depth());
    runner.run(small_corner::parameters_for(effect));
    return runner.download(image);
}

std::vector<float> by_opengl(const effect_view& effect, std::string_view image, unsigned components = 1) {
    opengl_host host(effect, small_corner::width, small_corner::height);
    host.upload_depth(small_corner::device_depth());
    host.run(small_corner::parameters_for(effect));
    return host.download(image, components);
}

const char* const recipes[] = {
    "directions:6x4/single_layer/hbao/reconstructed_normals/bilateral:2",
    "hemisphere_points:9/single_layer/ssao/reconstructed_normals/linearised_depth/upsample:2",
    "poisson_disk:9/single_layer/hbao_plus/reconstructed_normals/bilateral:2/upsample:3/bilateral:2",
    "sample_box/summed_area:2/mean_height/reconstructed_normals",
    "sample_box/summed_area_adaptive:3/mean_height/reconstructed_normals",
    "sample_box/mip_chain:3x2/mean_height/reconstructed_normals",
    "directions:4x2/depth_pyramid:12/hbao/reconstructed_normals",
};

}

TEST_CASE("compute passes for OpenGL give the picture of those for Vulkan") {
    for (const std::string text : recipes) {
        CAPTURE(text);
        const composition vulkan{recipe(std::string_view(text))}, opengl{recipe(text + "/opengl")};
        const std::vector<float> expected = by_vulkan(vulkan, "visibility");
        CHECK(std::ranges::min(expected) < 0.85f); // the corner is dark, and the open floor is not
        CHECK(std::ranges::max(expected) > 0.98f);
        CHECK(small_corner::largest_difference(by_opengl(opengl, "visibility"), expected) <=
              small_corner::a_step);
    }
}

TEST_CASE("fragment passes for OpenGL give the picture of those for Vulkan") {
    for (const std::string text : recipes) {
        CAPTURE(text);
        const composition vulkan{recipe(std::string_view(text))}, opengl{recipe(text + "/fragment/opengl")};
        CHECK(small_corner::largest_difference(by_opengl(opengl, "visibility"),
                                               by_vulkan(vulkan, "visibility")) <= small_corner::a_step);
    }
}

TEST_CASE("texel fetches and image loads give the same picture in OpenGL") {
    for (const std::string text : {recipes[0], recipes[1], recipes[3]}) {
        CAPTURE(text);
        const composition fetching{recipe(text + "/opengl")}, loading{recipe(text + "/opengl/image_load")};
        CHECK(by_opengl(loading, "visibility") == by_opengl(fetching, "visibility"));
    }
}

TEST_CASE("a pass for OpenGL stores to all its images") {
    const std::string text = "directions:6x4/single_layer/hbao/reconstructed_normals/bent_cone/bilateral:2";
    const composition vulkan{recipe(std::string_view(text))};
    const std::vector<float> expected = by_vulkan(vulkan, "bent_cone");
    CHECK(std::ranges::max(expected) > 0.9f);
    for (const char* stage : {"/compute", "/fragment"}) {
        CAPTURE(std::string(stage));
        const composition opengl{recipe(text + stage + "/opengl")};
        CHECK(small_corner::largest_difference(by_opengl(opengl, "bent_cone", 4), expected) < 0.01f);
        CHECK(small_corner::largest_difference(by_opengl(opengl, "visibility"),
                                               by_vulkan(vulkan, "visibility")) <= small_corner::a_step);
    }
}

TEST_CASE("a host's compute shader around functions for OpenGL gives that picture too") {
    for (const std::string text : {"directions:6x4/single_layer/hbao/reconstructed_normals",
                                   "sample_box/summed_area:2/mean_height/reconstructed_normals"}) {
        CAPTURE(text);
        const composition vulkan{recipe(std::string_view(text))};
        const hosted_effect opengl(text + "/functions:0x1/opengl", functions_host);
        CHECK(small_corner::largest_difference(by_opengl(opengl.view(), "visibility"),
                                               by_vulkan(vulkan, "visibility")) <= small_corner::a_step);
    }
}
