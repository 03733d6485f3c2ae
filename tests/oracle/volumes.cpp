// SPDX-License-Identifier: MIT
// Volumes by points and by lines: whole images against the oracle's, and scenes whose answer is an integral.
// The tolerances are those of whole_images.cpp: 8 bits, and single precision that picks another texel for a
// few taps.
#include "run.hpp"
#include "volume.hpp"

#include <doctest/doctest.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

namespace {

using oracle::lens;
using kind = oracle::surface::kind;

constexpr double one_step = 1.0 / 255;

struct technique {
    std::string recipe;
    std::function<double(const oracle::picture&, const oracle::receiver&, const oracle::settings&)> occlusion;
};

/// Without the points that their texels moved out of the hemisphere.
std::vector<oracle::tap> above(const oracle::receiver& r, std::vector<oracle::tap> points) {
    std::erase_if(points,
                  [&](const oracle::tap& t) { return glm::dot(t.point - r.position, r.normal) <= 0; });
    return points;
}

const std::vector<technique>& techniques() {
    static const std::vector<technique> all{
        {"sphere_points:12/single_layer/point_volume",
         [](const auto& p, const auto& r, const auto& s) {
             return oracle::point_volume(p, r, s, oracle::sphere_points(p, r, s, 12));
         }},
        {"hemisphere_points:12/single_layer/point_volume",
         [](const auto& p, const auto& r, const auto& s) {
             return oracle::point_volume(p, r, s, above(r, oracle::hemisphere_points(p, r, s, 12)[0]));
         }},
        {"sphere_lines:9/single_layer/line_volume",
         [](const auto& p, const auto& r, const auto& s) {
             return oracle::line_volume(p, r, s, oracle::disk_lines(p, r, s, 9, false));
         }},
        {"hemisphere_lines:9/single_layer/line_volume",
         [](const auto& p, const auto& r, const auto& s) {
             return oracle::line_volume(p, r, s, oracle::disk_lines(p, r, s, 9, true));
         }},
        {"sphere_points:12/single_layer/ssao",
         [](const auto& p, const auto& r, const auto& s) {
             return oracle::ssao(p, r, s, {oracle::sphere_points(p, r, s, 12)});
         }},
    };
    return all;
}

oracle::difference differ(const technique& t, const std::string& parts, lens seen_by, int tile = 0,
                          float falloff = 1, bool reconstructed = false, glm::ivec2 size = {97, 61}) {
    const oracle::picture p = oracle::draw(oracle::still_life(), seen_by, size.x, size.y);
    const std::string text = t.recipe + parts + (seen_by == lens::orthographic ? "/orthographic" : "");
    const crease::recipe chosen{std::string_view(text)};
    REQUIRE_MESSAGE(static_cast<bool>(chosen), chosen.error());
    const auto composed = std::make_unique<crease::composition>(chosen);
    crease::parameters how = oracle::view_parameters(p, composed->view(), 0.5);
    crease::set(how, composed->view().settings, "falloff", falloff); // where the estimator has one
    oracle::settings s = oracle::settings_of(how, *composed);
    if (tile > 0)
        s.noise = "tiled_noise:" + std::to_string(tile);
    const oracle::visibility_image expected = oracle::main_pass(
        p, s, 1, reconstructed, [&](const oracle::receiver& r) { return t.occlusion(p, r, s); });
    return oracle::compare(oracle::run(p, composed->view(), how), expected);
}

// Texels move points and lines by a good part of the radius, so few find another one by rounding.
constexpr oracle::difference of_few_texels{
    .typical = 0.004, .mean = 0.0005, .border = 0.0006, .most = 0.3, .bias = 0.0004};

/// Two walls at a right angle that meet in the line x = 0, at depth 6; each is seen at 45 degrees.
oracle::picture corner() {
    const double s = std::sqrt(0.5);
    return oracle::draw({{kind::plane, {0, 0, -6}, {s, 0, s}}, {kind::plane, {0, 0, -6}, {-s, 0, s}}},
                        lens::orthographic, 301, 200);
}

/// The least of the pixels that are further from the border than `margin`, so that none of their taps is off
/// the picture.
float least_inside(const oracle::picture& p, const std::vector<float>& image, int margin) {
    float least = 1;
    for (int y = margin; y < p.height - margin; ++y)
        for (int x = margin; x < p.width - margin; ++x)
            least = std::min(least, image[p.index(x, y)]);
    return least;
}

/// The mean over a block of 4 x 16 pixels, which holds each place of the tile of the noise as often.
double mean_around(const oracle::picture& p, const std::vector<float>& image, int x, int y) {
    double sum = 0;
    for (int i = 0; i < 16; ++i)
        for (int j = 0; j < 4; ++j)
            sum += image[p.index(x + j, y + i)] / 64.0;
    return sum;
}

}

TEST_CASE("volumes by points and by lines, in every projection") {
    for (const technique& t : techniques())
        for (lens seen_by :
             {lens::standard, lens::reversed, lens::infinite, lens::off_centre, lens::orthographic}) {
            CAPTURE(t.recipe);
            CAPTURE(static_cast<int>(seen_by));
            oracle::check_within(differ(t, "", seen_by), oracle::of_rounding);
        }
}

TEST_CASE("volumes of a few texels") {
    for (const technique& t : techniques())
        for (glm::ivec2 size : {glm::ivec2(24, 15), {48, 30}}) {
            CAPTURE(t.recipe);
            CAPTURE(size.x);
            oracle::check_within(differ(t, "", lens::standard, 0, 1, false, size), of_few_texels);
        }
}

TEST_CASE("volumes with tiled noise, falloffs, reconstructed normals and as fragments") {
    for (const technique& t : techniques()) {
        CAPTURE(t.recipe);
        CHECK(differ(t, "/tiled_noise", lens::standard, 4).mean < 0.6 * one_step);
        CHECK(differ(t, "/tiled_noise:1", lens::off_centre, 1).mean < 0.6 * one_step);
        CHECK(differ(t, "/tiled_noise:3/fragment", lens::orthographic, 3).mean < 0.6 * one_step);
        CHECK(differ(t, "", lens::standard, 0, 0.1f).mean < 0.6 * one_step);
        CHECK(differ(t, "/linear_depth", lens::standard, 0, 10).mean < 0.6 * one_step);
        CHECK(differ(t, "/reconstructed_normals", lens::standard, 0, 1, true).mean < one_step);
    }
}

TEST_CASE("a plane that faces the eye fills half of the sphere, which does not occlude") {
    const oracle::picture p =
        oracle::draw({{kind::plane, {0, 0, -4}, {0, 0, 1}}}, lens::orthographic, 96, 64);
    for (const char* recipe :
         {"sphere_points:64/single_layer/point_volume", "sphere_lines:12/single_layer/line_volume"})
        CHECK(least_inside(p, oracle::run(p, std::string(recipe) + "/orthographic", 0.5), 12) >= 0.995f);
}

TEST_CASE("beside the edge of a corner, by the volume that the other wall cuts off") {
    // At distance a from the other wall it cuts half a spherical cap off the hemisphere, of the height R - a;
    // the sphere it shares with the receiver's own wall, so that the excess over a half is the same.
    const oracle::picture p = corner();
    const double radius = 1;
    for (const char* recipe :
         {"hemisphere_lines:256/single_layer/line_volume", "sphere_lines:256/single_layer/line_volume",
          "sphere_points:256/single_layer/point_volume"}) {
        const std::vector<float> image =
            oracle::run(p, std::string(recipe) + "/orthographic/tiled_noise", radius);
        for (int x : {152, 160, 175, 190}) {
            const double a =
                std::abs(p.position(x + 1, 100).x + p.position(x + 2, 100).x) / 2 * std::sqrt(2.0);
            const double filled =
                (radius - a) * (radius - a) * (2 * radius + a) / (4 * radius * radius * radius);
            CAPTURE(std::string(recipe));
            CAPTURE(a);
            CHECK(std::abs(mean_around(p, image, x, 92) - (1 - filled)) < 0.02);
        }
    }
}

TEST_CASE("beside the edge of a corner, by points, which weigh by the cosine and the distance") {
    // Of a direction w with the cosine c to the other wall the share 1 - a / (c R) of the points is behind
    // it.
    const oracle::picture p = corner();
    const double radius = 1;
    const std::vector<float> image =
        oracle::run(p, "hemisphere_points:256/single_layer/point_volume/orthographic/tiled_noise", radius);
    for (int x : {152, 160, 175, 190}) {
        const double a = std::abs(p.position(x + 1, 100).x + p.position(x + 2, 100).x) / 2 * std::sqrt(2.0);
        double filled = 0;
        const int slices = 400;
        for (int i = 0; i < slices; ++i)
            for (int j = 0; j < slices; ++j) {
                const double sine = std::sqrt((i + 0.5) / slices);
                const double c = sine * std::cos(2 * glm::pi<double>() * (j + 0.5) / slices);
                if (c > 0)
                    filled += std::max(0.0, 1 - a / (c * radius)) / (slices * slices);
            }
        CAPTURE(a);
        CHECK(std::abs(mean_around(p, image, x, 92) - (1 - filled)) < 0.02);
    }
}

TEST_CASE("a surface far before the volume casts no halo") {
    // The half plane's edge is at x = 0; the wall lies 3 radii behind it.
    const oracle::picture p =
        oracle::draw({{kind::plane, {0, 0, -6}, {0, 0, 1}}, {kind::half_plane, {0, 0, -4.5}, {0, 0, 1}}},
                     lens::orthographic, 200, 133);
    for (const char* recipe :
         {"sphere_points:64/single_layer/point_volume", "hemisphere_points:64/single_layer/point_volume",
          "sphere_lines:12/single_layer/line_volume", "hemisphere_lines:12/single_layer/line_volume"}) {
        CAPTURE(std::string(recipe));
        CHECK(least_inside(p, oracle::run(p, std::string(recipe) + "/orthographic", 0.5), 20) >= 0.995f);
    }
}

TEST_CASE("odd sizes, down to one pixel") {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), {7, 5}, {1, 9}, {16, 1}, {65, 33}})
        for (const char* recipe : {"hemisphere_points:16/single_layer/point_volume",
                                   "hemisphere_lines:12/single_layer/line_volume",
                                   "box_window:15/single_layer/unsharp_mask/shade"})
            for (const char* parts :
                 {"/tiled_noise", "/bilateral/upsample:2", "/bilateral/upsample:4/fragment"}) {
                CAPTURE(size.x);
                CAPTURE(size.y);
                CAPTURE(std::string(recipe) + parts);
                const oracle::picture p =
                    oracle::draw({{kind::plane, {0, 0, -2}, {0, 0, 1}}}, lens::standard, size.x, size.y);
                const std::vector<float> image = oracle::run(p, std::string(recipe) + parts, 0.5);
                CHECK(image.size() == p.device.size());
                CHECK(*std::min_element(image.begin(), image.end()) >= 0.995f);
            }
}
