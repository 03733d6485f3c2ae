// SPDX-License-Identifier: MIT
// Whole programs as text. Run with CREASE_COLLECT=1 to write them anew, and read the difference.
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace {

struct golden {
    const char* file;
    const char* recipe;
    std::size_t pass;
};

constexpr golden programs[] = {
    {"hbao_compute.glsl", "directions:8x4/single_layer/hbao", 0},
    {"ssao_fragment_opengl.glsl",
     "hemisphere_points:16/single_layer/ssao/orthographic/reconstructed_normals/fragment/opengl", 0},
    {"bilateral_after_upsample.glsl", "directions:8x4/single_layer/hbao_plus/upsample:2/bilateral:4", 2},
    {"hbao_plus_functions.glsl", "poisson_disk:16/single_layer/hbao_plus/linear_depth/functions:1x4x10", 0},
};

std::string content_of(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

}

TEST_CASE("programs are as they were") {
    for (const golden& each : programs) {
        CAPTURE(std::string(each.file));
        const crease::composition composed{crease::recipe(std::string_view(each.recipe))};
        REQUIRE(each.pass < composed.view().passes.size());
        const std::string text = joined(composed.view().passes[each.pass].pieces);
        const std::string path = CREASE_GOLDEN "/" + std::string(each.file);
        if (std::getenv("CREASE_COLLECT"))
            std::ofstream(path) << text;
        CHECK(text == content_of(path));
    }
}
