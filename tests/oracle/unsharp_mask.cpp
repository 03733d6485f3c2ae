// SPDX-License-Identifier: MIT
// The unsharp mask against its paper's listing, pixel by pixel. The device depth is the same on both sides;
// the shader makes linear depth of it in single precision, which at the far end of the picture leaves 1e-5 of
// linearised depth, and times the factor 20 2e-4 of shade. A neighbour whose difference is the threshold to
// within that may fall on either side of it.
#include "run.hpp"
#include "volume.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace {

using oracle::lens;
using kind = oracle::surface::kind;

constexpr double near_plane = 0.1, far_plane = 50; // of oracle::make_projection
constexpr double rounding = 1e-5;                  // of linearised depth

std::vector<float> shades(const oracle::picture& p, const std::string& text, float threshold,
                          std::string_view image = "shade") {
    const crease::recipe chosen{std::string_view(text)};
    REQUIRE_MESSAGE(static_cast<bool>(chosen), chosen.error());
    const auto composed = std::make_unique<crease::composition>(chosen);
    crease::parameters how = oracle::view_parameters(p, composed->view(), 1);
    oracle::set(how, *composed, "threshold", threshold);
    return oracle::run(p, composed->view(), how, image);
}

std::vector<double> listing(const oracle::picture& p, int kernel_dimension, double threshold) {
    std::vector<double> all;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            all.push_back(p.background(x, y) ? 0
                                             : oracle::unsharp_shade(p, x, y, kernel_dimension, near_plane,
                                                                     far_plane, threshold, 20));
    return all;
}

/// Checks every pixel against the listing, with the threshold as it is and as rounding may move it.
void check_listing(const oracle::picture& p, const std::vector<float>& shade, int kernel_dimension,
                   double threshold, double tolerance = 20 * rounding) {
    const std::vector<double> expected = listing(p, kernel_dimension, threshold);
    const std::vector<double> fewer = listing(p, kernel_dimension, threshold - rounding);
    const std::vector<double> more = listing(p, kernel_dimension, threshold + rounding);
    std::size_t apart = 0, on_threshold = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const auto [least, most] = std::minmax({expected[i], fewer[i], more[i]});
        apart += !(shade[i] > least - tolerance && shade[i] < most + tolerance);
        on_threshold += most - least > tolerance;
    }
    CHECK(apart == 0);
    CHECK(on_threshold < expected.size() / 20);
}

}

TEST_CASE("the unsharp mask is the listing's at every pixel, also at the borders") {
    for (int size : {2, 15, 40})
        for (lens seen_by : {lens::standard, lens::off_centre})
            for (double threshold : {0.02, 0.1, 1.0}) { // of figure 5, of figure 4, and none
                CAPTURE(size);
                CAPTURE(threshold);
                const oracle::picture p = oracle::draw(oracle::still_life(), seen_by, 97, 61);
                check_listing(
                    p,
                    shades(p, "box_window:" + std::to_string(size) + "/single_layer/unsharp_mask/shade",
                           static_cast<float>(threshold)),
                    size, threshold);
            }
}

TEST_CASE("visibility is one less the shade, without its highlights") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 97, 61);
    const std::string text = "box_window:15/single_layer/unsharp_mask";
    const std::vector<float> shade = shades(p, text + "/shade", 0.02f);
    const std::vector<float> dark_only = shades(p, text + "/shade:0", 0.02f);
    const std::vector<float> visibility = shades(p, text, 0.02f, "visibility");
    const std::vector<float> beside_shade = shades(p, text + "/shade", 0.02f, "visibility");
    bool highlight = false;
    for (std::size_t i = 0; i < shade.size(); ++i) {
        highlight = highlight || shade[i] < -0.01f;
        CHECK(dark_only[i] == std::max(shade[i], 0.0f));
        CHECK(std::abs(visibility[i] - std::clamp(1 - shade[i], 0.0f, 1.0f)) <= 0.6f / 255);
        CHECK(beside_shade[i] == visibility[i]);
    }
    CHECK(highlight);
}

TEST_CASE("the window stays in the picture: a facing plane has no shade, to the border") {
    const oracle::picture p = oracle::draw({{kind::plane, {0, 0, -3}, {0, 0, 1}}}, lens::standard, 50, 30);
    for (float shade : shades(p, "box_window:40/single_layer/unsharp_mask/shade", 0.02f))
        CHECK(std::abs(shade) < 1e-5f);
}

TEST_CASE("every encoding of depth gives the same shade") {
    const std::string text = "box_window:15/single_layer/unsharp_mask/shade";
    const auto scene = [](lens seen_by) { return oracle::draw(oracle::still_life(), seen_by, 97, 61); };
    check_listing(scene(lens::standard), shades(scene(lens::reversed), text, 0.02f), 15, 0.02);
    for (const char* encoding : {"/linear_depth", "/linearised_depth"})
        check_listing(scene(lens::standard), shades(scene(lens::standard), text + encoding, 0.02f), 15, 0.02);
}

TEST_CASE("the shade goes through the filters") {
    const oracle::picture p = oracle::draw({{kind::plane, {0, 0, -3}, {0, 0, 1}}}, lens::standard, 50, 30);
    for (const char* filters : {"/bilateral", "/upsample:2", "/plane_filter/upsample:4"})
        for (float shade :
             shades(p, std::string("box_window:15/single_layer/unsharp_mask/shade") + filters, 0.02f))
            CHECK(std::abs(shade) < 1e-5f);
}

TEST_CASE("without a threshold a window by one table is the listing's at every pixel") {
    for (int size : {2, 15, 40, 120}) // the last takes in the whole picture and more
        for (lens seen_by : {lens::standard, lens::off_centre}) {
            CAPTURE(size);
            const oracle::picture p = oracle::draw(oracle::still_life(), seen_by, 97, 61);
            // A sum over an area is as exact as the places of the table, however few its texels.
            const double tolerance = 20 * (rounding + 2e-4 / (size * size));
            for (const char* parts : {"/shade", "/shade/fragment", "/shade/linear_depth"})
                check_listing(
                    p,
                    shades(p, "box_area:" + std::to_string(size) + "x1/summed_area/unsharp_mask" + parts,
                           1.0f),
                    size, 1.0, tolerance);
        }
    const oracle::picture one = oracle::draw(oracle::still_life(), lens::standard, 1, 1);
    CHECK(std::abs(shades(one, "box_area:15/summed_area/unsharp_mask/shade", 1.0f)[0]) < 20 * rounding);
}

TEST_CASE("with a threshold a window by tables leaves layers out") {
    for (int layers : {1, 8, 64})
        for (double threshold : {0.02, 0.1, 1.0}) {
            CAPTURE(layers);
            CAPTURE(threshold);
            const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 97, 61);
            const std::vector<float> shade = shades(
                p, "box_area:15x1/summed_area_uniform:" + std::to_string(layers) + "/unsharp_mask/shade",
                static_cast<float>(threshold));
            std::vector<double> expected;
            for (int y = 0; y < p.height; ++y)
                for (int x = 0; x < p.width; ++x)
                    expected.push_back(p.background(x, y)
                                           ? 0
                                           : oracle::unsharp_shade_of_layers(
                                                 p, x, y, 15, near_plane, far_plane, threshold, 20, layers));
            // A texel between two layers may fall into either.
            const oracle::difference d = oracle::compare(shade, expected, p.width);
            CHECK(d.typical < 20 * rounding);
            CHECK(d.mean < 20 * rounding);
        }
}

TEST_CASE("more layers come nearer to the threshold of the listing") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 97, 61);
    const std::vector<double> expected = listing(p, 40, 0.02);
    double before = 1e9;
    for (int layers : {4, 16, 64}) {
        const double apart =
            oracle::compare(
                shades(p,
                       "box_area:40x1/summed_area_uniform:" + std::to_string(layers) + "/unsharp_mask/shade",
                       0.02f),
                expected, p.width)
                .mean;
        MESSAGE(layers << " layers: " << apart << " of shade from the listing");
        CHECK(apart < before);
        before = apart;
    }
}

TEST_CASE("a window by smaller tables or adaptive layers has no shade on a facing plane") {
    const oracle::picture p = oracle::draw({{kind::plane, {0, 0, -3}, {0, 0, 1}}}, lens::standard, 50, 30);
    for (const char* source :
         {"summed_area:2", "summed_area:3", "summed_area_uniform:16x2", "summed_area_adaptive:4",
          "summed_area_adaptive:4x4", "n_buffer:6", "n_buffer:5x2", "mip_chain:6"})
        for (float shade : shades(p, "box_area:40/" + std::string(source) + "/unsharp_mask/shade", 0.02f))
            CHECK(std::abs(shade) < 20 * rounding);
}

TEST_CASE("a window that is one area differs from the listing only where it reaches past the far edges") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 97, 61);
    const std::vector<float> whole = shades(p, "box_area:15x1/summed_area/unsharp_mask/shade", 1.0f);
    const std::vector<float> one = shades(p, "box_area:15/summed_area/unsharp_mask/shade", 1.0f);
    bool differs = false;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            const bool past = x + 7 > p.width || y + 7 > p.height;
            const float apart = std::abs(whole[p.index(x, y)] - one[p.index(x, y)]);
            differs = differs || apart > 1e-3f;
            CHECK((past || apart <= 1e-6f));
        }
    CHECK(differs);
}

namespace {

/// The same picture with depth the other way round.
oracle::picture turned(oracle::picture p) {
    glm::dmat4 turn(1);
    turn[2][2] = -1;
    turn[3][2] = 1;
    p.projection = turn * p.projection;
    p.reversed = !p.reversed;
    for (float& z : p.device)
        z = 1 - z;
    return p;
}

}

TEST_CASE("without a far plane differences of depth count in radii") {
    const oracle::picture reversed = oracle::draw(oracle::still_life(), lens::infinite, 97, 61);
    for (const oracle::picture& p : {reversed, turned(reversed)})
        for (int size : {15, 40})
            for (double threshold : {0.02, 0.1}) {
                CAPTURE(p.reversed);
                CAPTURE(size);
                CAPTURE(threshold);
                const std::vector<float> shade =
                    shades(p, "box_window:" + std::to_string(size) + "/single_layer/unsharp_mask/shade",
                           static_cast<float>(threshold));
                std::vector<double> expected;
                for (int y = 0; y < p.height; ++y)
                    for (int x = 0; x < p.width; ++x)
                        expected.push_back(p.background(x, y) ? 0
                                                              : oracle::unsharp_shade_without_far(
                                                                    p, x, y, size, 1, threshold, 20));
                const oracle::difference d = oracle::compare(shade, expected, p.width);
                CHECK(d.typical < 2e-3);
                CHECK(d.mean < 2e-4);
                CHECK(*std::max_element(expected.begin(), expected.end()) > 0.1);
            }
}

TEST_CASE("without a far plane every source of areas gives the shade of the window") {
    const oracle::picture p =
        oracle::draw({{kind::plane, {0, 0, -4}, {0, 0, 1}}, {kind::half_plane, {0, 0, -3.5}, {0, 0, 1}}},
                     lens::infinite, 97, 61);
    const std::vector<float> window = shades(p, "box_window:16/single_layer/unsharp_mask/shade", 1.0f);
    // Of the texels just behind the edge 7 of 16 columns are half a radius nearer: 20 * 0.5 / 50 * 7 / 16.
    CHECK(std::abs(*std::max_element(window.begin(), window.end()) - 0.0875) < 1e-6);
    for (const char* source :
         {"summed_area", "summed_area_uniform:8", "summed_area_adaptive:4", "n_buffer:5"}) {
        CAPTURE(std::string(source));
        const std::vector<float> areas =
            shades(p, "box_area:16x1/" + std::string(source) + "/unsharp_mask/shade", 1.0f);
        for (int y = 8; y < p.height - 8; ++y) // where a window is one whole area
            for (int x = 8; x < p.width - 8; ++x)
                CHECK(std::abs(areas[p.index(x, y)] - window[p.index(x, y)]) < 1e-4f);
    }
}

TEST_CASE("a plane that leans has the shade of the curve that its depth is in the picture") {
    for (lens seen_by : {lens::standard, lens::infinite})
        for (double degrees : {0.0, 30.0, 60.0}) {
            CAPTURE(static_cast<int>(seen_by));
            CAPTURE(degrees);
            const glm::dvec3 normal(std::sin(glm::radians(degrees)), 0, std::cos(glm::radians(degrees)));
            const oracle::picture p = oracle::draw({{kind::plane, {0, 0, -3}, normal}}, seen_by, 97, 61);
            // Where the ray (x, y, -1) meets it, the plane is 3 cos / (cos - x sin) deep.
            const auto depth = [&](int x) {
                const double across =
                    p.unproject({x + 0.5, 30.5}, 0.5).x / -p.unproject({x + 0.5, 30.5}, 0.5).z;
                const double d = 3 * normal.z / (normal.z - across * normal.x);
                return seen_by == lens::standard ? 2 * d / (d + far_plane) : d / 50;
            };
            for (const char* source : {"box_window:14/single_layer", "box_area:14/summed_area"}) {
                CAPTURE(std::string(source));
                const std::vector<float> shade = shades(p, std::string(source) + "/unsharp_mask/shade", 1.0f);
                for (int x : {20, 48, 70}) {
                    double mean = 0;
                    for (int i = x - 7; i < x + 7; ++i)
                        mean += depth(i) / 14;
                    CHECK(std::abs(shade[p.index(x, 30)] - 20 * (depth(x) - mean)) < 2e-4);
                }
            }
        }
}
