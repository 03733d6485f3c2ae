// SPDX-License-Identifier: MIT
// Scenes whose cosine-weighted occlusion is known, by the estimators of half slices.
#include "run.hpp"

#include <doctest/doctest.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

using oracle::lens;
using kind = oracle::surface::kind;

constexpr double pi = glm::pi<double>();

const char* const recipes[] = {"half_directions:1x8/single_layer/cosine_bitmask:0x1",
                               "half_directions:1x8/single_layer/cosine_bitmask:1x0",
                               "half_directions:2x4/single_layer/gtao",
                               "half_directions:1x8/single_layer/visibility_bitmask",
                               "slices:3x3/single_layer/gtao",
                               "slices:3x3/single_layer/visibility_bitmask",
                               "slices:3x3/single_layer/cosine_bitmask",
                               "directions:3x5/single_layer/cosine_bitmask",
                               "directions:4x4/single_layer/gtao"};

/// The mean of an image around its middle.
double middle(const oracle::picture& p, const std::vector<float>& image, int half) {
    double sum = 0;
    for (int y = p.height / 2 - half; y < p.height / 2 + half; ++y)
        for (int x = p.width / 2 - half; x < p.width / 2 + half; ++x)
            sum += image[p.index(x, y)];
    return sum / (4.0 * half * half);
}

/// What of the cosine lobe over a floor hits a wall at a right angle within the radius: `falloff` of the
/// distance in radii.
template <class Falloff>
double by_a_wall(double distance, Falloff falloff) {
    constexpr int parts = 600;
    double sum = 0;
    for (int i = 0; i < parts; ++i)
        for (int j = 0; j < parts; ++j) {
            const double azimuth = 2 * pi * (i + 0.5) / parts, sine = std::sqrt((j + 0.5) / parts);
            const double towards = sine * std::cos(azimuth);
            if (towards > distance)
                sum += falloff(distance / towards);
        }
    return 1 - sum / (double{parts} * parts);
}

/// A floor by a wall, seen so that both lean by 45 degrees and each is seen alike; their crease lies along y.
struct corner {
    oracle::picture seen;
    int column;           ///< of the texels that lie so far away from the crease on one side
    glm::dvec3 to_crease; ///< from there
};

corner draw_corner(double away) {
    const double s = std::sqrt(0.5);
    const glm::dvec3 crease(0, 0, -6);
    corner c{oracle::draw({{kind::plane, crease, {s, 0, s}}, {kind::plane, crease, {-s, 0, s}}},
                          lens::orthographic, 300, 200),
             0,
             {}};
    const auto way = [&](int x) { return crease - c.seen.position(x, 100) * glm::dvec3(1, 0, 1); };
    for (int x = 0; x < c.seen.width; ++x)
        if (std::abs(glm::length(way(x)) - away) < std::abs(glm::length(way(c.column)) - away))
            c.column = x;
    c.to_crease = way(c.column);
    return c;
}

}

TEST_CASE("a plane is exactly open by half slices at every slant, to the picture's edge") {
    for (const char* recipe : recipes)
        for (double degrees : {0.0, 30.0, 60.0, 75.0, 80.0, 85.0})
            for (double distance : {0.5, 3.0, 20.0})
                for (lens seen_by : {lens::standard, lens::infinite, lens::orthographic}) {
                    CAPTURE(std::string(recipe));
                    CAPTURE(degrees);
                    CAPTURE(distance);
                    CAPTURE(static_cast<int>(seen_by));
                    const double a = degrees * pi / 180;
                    for (glm::dvec3 normal :
                         {glm::dvec3(std::sin(a), 0, std::cos(a)), glm::dvec3(0, std::sin(a), std::cos(a))}) {
                        const oracle::picture p =
                            oracle::draw({{kind::plane, {0, 0, -distance}, normal}}, seen_by, 96, 64);
                        const std::vector<float> image = oracle::run(
                            p, std::string(recipe) + (seen_by == lens::orthographic ? "/orthographic" : ""),
                            0.3 * distance);
                        CHECK(*std::min_element(image.begin(), image.end()) == 1);
                    }
                }
}

TEST_CASE("a floor by a wall is as dark as the cosine lobe that the wall takes, hard and linear") {
    const corner c = draw_corner(0.4);
    const double radius = 2, distance = glm::length(c.to_crease) / radius;
    const auto mean = [&](const std::string& recipe) {
        const std::vector<float> image = oracle::run(c.seen, recipe + "/orthographic", radius);
        double sum = 0;
        for (int y = 60; y < 140; ++y)
            sum += image[c.seen.index(c.column, y)];
        return sum / 80;
    };
    const double hard = by_a_wall(distance, [](double) { return 1; }),
                 linear = by_a_wall(distance, [](double d) { return 1 - d; });
    CAPTURE(hard);
    CAPTURE(linear);
    // 31 sectors, and the two terms of B, keep what is hidden to a few hundredths.
    CHECK(mean("half_directions:16x32/single_layer/cosine_bitmask:0x0") ==
          doctest::Approx(hard).epsilon(0.04));
    CHECK(mean("half_directions:16x32/single_layer/cosine_bitmask:1x0") ==
          doctest::Approx(linear).epsilon(0.04));
    CHECK(mean("slices:16x32/single_layer/cosine_bitmask:0x0") == doctest::Approx(hard).epsilon(0.04));
    CHECK(mean("slices:16x32/single_layer/visibility_bitmask") == doctest::Approx(hard).epsilon(0.04));
}

TEST_CASE("beside a wall the bent normal is the mean of what stays open of the cosine lobe") {
    const corner c = draw_corner(0.4);
    const double radius = 2, distance = glm::length(c.to_crease) / radius;
    glm::dvec2 open(0); // along the floor to the wall, and off the floor
    constexpr int parts = 600;
    int hidden = 0;
    for (int i = 0; i < parts; ++i)
        for (int j = 0; j < parts; ++j) {
            const double sine = std::sqrt((j + 0.5) / parts),
                         towards = sine * std::cos(2 * pi * (i + 0.5) / parts);
            if (towards <= distance)
                open += glm::dvec2(towards, std::sqrt(1 - sine * sine));
            else
                ++hidden;
        }
    const double lean = std::atan2(-open.x, open.y) * 180 / pi;
    CAPTURE(lean);
    // What is hidden counts as if it stood in the middle of an eighth of the angles from the eye to the
    // tangent plane, which are 135 degrees at most.
    const double off = 135.0 / 8 / 2 * hidden / glm::length(open);
    CAPTURE(off);
    for (const std::string recipe :
         {"half_directions:16x32/single_layer/cosine_bitmask:0x0",
          "slices:16x32/single_layer/cosine_bitmask:0x0", "slices:16x32/single_layer/visibility_bitmask"}) {
        CAPTURE(recipe);
        const auto composed = oracle::compose(recipe + "/bent_cone/orthographic");
        const std::vector<float> image = oracle::run(
            c.seen, composed->view(), oracle::view_parameters(c.seen, composed->view(), radius), "bent_cone");
        glm::dvec2 bent(0);
        for (int y = 60; y < 140; ++y) {
            const std::size_t texel = c.seen.index(c.column, y), at = 4 * texel;
            const glm::dvec3 each(image[at], image[at + 1], image[at + 2]);
            bent += glm::dvec2(glm::dot(each, glm::normalize(c.to_crease)),
                               glm::dot(each, glm::dvec3(c.seen.normals[texel])));
        }
        const double bends = std::atan2(-bent.x, bent.y) * 180 / pi;
        CAPTURE(bends);
        CHECK(std::abs(bends - lean) < off);
    }
}

TEST_CASE("the inside of a sphere hides the share of the lobe whose chords end within the radius") {
    // A chord at an angle to the normal is 2 S cos of it long; S is the radius of the sphere.
    const double sphere = 1.5, radius = 1.5;
    const oracle::picture p =
        oracle::draw({{kind::inside_of_sphere, {0, 0, -0.6}, {}, sphere}}, lens::orthographic, 240, 160);
    // Of the lobe 2 c dc: all with c < R / 2 S by hard, less c 2 S / R by linear.
    const double most = radius / (2 * sphere), hard = 1 - most * most, linear = 1 - most * most / 3;
    const auto mean = [&](const std::string& recipe) {
        return middle(p, oracle::run(p, recipe + "/orthographic", radius), 10);
    };
    CHECK(mean("half_directions:8x32/single_layer/cosine_bitmask:0x0") ==
          doctest::Approx(hard).epsilon(0.04));
    CHECK(mean("half_directions:8x32/single_layer/cosine_bitmask:1x0") ==
          doctest::Approx(linear).epsilon(0.04));
}
