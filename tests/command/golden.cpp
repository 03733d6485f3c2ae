// SPDX-License-Identifier: MIT
// Pictures of a dozen recipes as they were when somebody last looked at them. Run with CREASE_COLLECT=1 to
// write them anew, and look at the difference.
#include "command.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

namespace {

struct picture {
    const char* file; ///< below tests/command/golden
    const char* recipe;
};

constexpr picture pictures[] = {
    {"hbao", "directions:8x4/single_layer/hbao/bilateral"},
    {"hbao_plus_half_size", "directions:4x4/single_layer/hbao_plus/linearised_depth/bilateral:2/upsample:2"},
    {"ssao_bent_cone", "hemisphere_points:16/single_layer/ssao/bent_cone/bilateral"},
    {"poisson_disk", "poisson_disk:16/single_layer/hbao_plus/reconstructed_normals/tiled_noise/fragment"},
    {"point_volume", "sphere_points:16/single_layer/point_volume/bilateral"},
    {"line_volume", "hemisphere_lines:12/single_layer/line_volume/bilateral"},
    {"unsharp_mask", "box_window:15/single_layer/unsharp_mask/shade"},
    {"depth_pyramid", "directions:6x3/depth_pyramid/hbao/bilateral"},
    {"adaptive_areas", "sample_box/summed_area_adaptive:4x2/mean_height"},
    {"mip_chain", "sample_box/mip_chain/mean_height"},
    {"front_first", "directions:4x4/stochastic_layers:8/hbao/front_first/bilateral"},
    {"deferred_layers", "directions:4x4/stochastic_layers:8/hbao/deferred_layers/bilateral"},
    {"second_view", "directions:4x4/stochastic_layers:8/hbao_plus/second_view/bilateral"},
};

/// Another processor or driver rounds otherwise. A radius that is larger by a millionth, which moves all by
/// as much as rounding does, changes the mean by at most 0.0033 steps of 255 and no pixel by more than 6; one
/// that is larger by a hundredth, which is a mistake, by 0.18 to 0.56.
constexpr double most_mean = 0.05, most_share = 0.002;
constexpr int far_off = 8; ///< steps; so far off may be that share of the pixels

}

TEST_CASE("golden: the pictures of a dozen recipes are what they were") {
    for (const picture& each : pictures) {
        CAPTURE(std::string(each.recipe));
        const std::filesystem::path kept = CREASE_GOLDEN "/" + std::string(each.file) + ".png";
        const temporary_folder folder;
        expect_success("render built-in --width 160 --height 90 --recipe " + std::string(each.recipe) +
                       " -o '" + (folder / "out").string() + "'");
        if (std::getenv("CREASE_COLLECT"))
            std::filesystem::copy_file(folder / "out/ao.png", kept,
                                       std::filesystem::copy_options::overwrite_existing);
        const std::vector<unsigned char> now = png_of(folder / "out/ao.png"), then = png_of(kept);
        REQUIRE(now.size() == 160 * 90);
        REQUIRE(then.size() == now.size());
        double sum = 0, off = 0;
        for (std::size_t i = 0; i < now.size(); ++i) {
            const int by = std::abs(now[i] - then[i]);
            sum += by;
            off += by > far_off;
        }
        const double count = static_cast<double>(now.size());
        CHECK(sum / count <= most_mean);
        CHECK(off / count <= most_share);
    }
}
