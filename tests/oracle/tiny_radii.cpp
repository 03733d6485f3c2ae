// SPDX-License-Identifier: MIT
// Radii that are small beside the distance, down to what single precision cannot tell from it: a plane is
// open, and where there is something to see it occludes as it does from near. And the other way round, a wide
// lens.
#include "run.hpp"
#include "techniques.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace {

using oracle::lens;
using kind = oracle::surface::kind;

const char* const recipes[] = {
    "hemisphere_points:16/single_layer/ssao", "hemisphere_points:16/single_layer/point_volume",
    "sphere_points:16/single_layer/point_volume", "hemisphere_lines:12/single_layer/line_volume",
    "sphere_lines:12/single_layer/line_volume"};

/// A picture of planes through a lens that shows a `zoom` times smaller part, the surfaces moved to its
/// middle.
oracle::picture zoomed(const std::vector<oracle::surface>& planes, lens seen_by, double zoom, int width,
                       int height) {
    oracle::picture p;
    p.width = width;
    p.height = height;
    p.projection = oracle::make_projection(seen_by, static_cast<double>(width) / height);
    p.reversed = seen_by == lens::reversed || seen_by == lens::infinite;
    for (int column = 0; column < 4; ++column) {
        p.projection[column][0] *= zoom;
        p.projection[column][1] *= zoom;
    }
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            glm::dvec3 eye, ray;
            p.ray({x + 0.5, y + 0.5}, eye, ray);
            double nearest = std::numeric_limits<double>::infinity();
            glm::dvec3 normal(0, 0, 1);
            for (const oracle::surface& s : planes) {
                const double t = glm::dot(s.point - eye, s.normal) / glm::dot(ray, s.normal);
                if (t > 0 && t < nearest) {
                    nearest = t;
                    normal = s.normal;
                }
            }
            p.normals.emplace_back(normal);
            const glm::dvec4 clip = p.projection * glm::dvec4(eye + nearest * ray, 1);
            const bool seen = -(eye + nearest * ray).z < 49.5;
            p.device.push_back(static_cast<float>(seen ? clip.z / clip.w : p.clear_value()));
        }
    return p;
}

}

TEST_CASE("a plane is open however small the radius is beside the distance") {
    for (const char* recipe : recipes)
        for (lens seen_by : {lens::standard, lens::reversed, lens::infinite, lens::orthographic})
            for (double zoom : {1.0, 100.0, 1000.0})
                for (double degrees : {0.0, 60.0, 80.0})
                    for (double distance : {1.0, 20.0}) {
                        const double a = degrees * 3.14159265358979 / 180;
                        const oracle::picture p =
                            zoomed({{kind::plane,
                                     {0, 0, -distance},
                                     {std::sin(a) * 0.6, std::sin(a) * 0.8, std::cos(a)}}},
                                   seen_by, zoom, 48, 32);
                        for (double share : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
                            CAPTURE(std::string(recipe));
                            CAPTURE(static_cast<int>(seen_by));
                            CAPTURE(zoom);
                            CAPTURE(degrees);
                            CAPTURE(distance);
                            CAPTURE(share);
                            const std::vector<float> image = oracle::run(
                                p,
                                std::string(recipe) + (seen_by == lens::orthographic ? "/orthographic" : ""),
                                share * distance);
                            CHECK(*std::min_element(image.begin(), image.end()) >= 0.995f);
                        }
                    }
}

TEST_CASE("a corner occludes as much where the radius is small beside the distance") {
    // Two walls at a right angle that meet at x = 0; a hundred times smaller the picture is the same.
    const double s = std::sqrt(0.5);
    const auto middle = [&](const char* recipe, double zoom) {
        const glm::dvec3 there(-0.3, 0, -6); // the lens of the tests is off-centre
        const oracle::picture p = zoomed({{kind::plane, there, {s, 0, s}}, {kind::plane, there, {-s, 0, s}}},
                                         lens::orthographic, zoom, 150, 100);
        const std::vector<float> image = oracle::run(p, std::string(recipe) + "/orthographic", 1 / zoom);
        double mean = 0;
        for (int y = 40; y < 60; ++y)
            for (int x = 65; x < 85; ++x)
                mean += image[p.index(x, y)] / 400;
        return mean;
    };
    for (const char* recipe : recipes) {
        CAPTURE(std::string(recipe));
        const double near = middle(recipe, 1);
        CHECK(near < 0.85);
        CHECK(std::abs(middle(recipe, 100) - near) < 0.0008);
    }
}

TEST_CASE("points behind the eye of a wide lens say nothing") {
    const oracle::picture p = zoomed({{kind::plane, {0, -1, 0}, {0, 1, 0}},
                                      {kind::plane, {0, 0, -3}, {0, 0, 1}},
                                      {kind::plane, {-2, 0, 0}, {1, 0, 0}}},
                                     lens::standard, 0.25, 97, 61);
    const oracle::technique& points = oracle::techniques()[0];
    const auto composed = oracle::compose(points.recipe());
    const crease::parameters how = oracle::view_parameters(p, composed->view(), 4);
    const oracle::settings s = oracle::settings_of(how, *composed);
    const auto expected = oracle::main_pass(
        p, s, 1, false, [&](const oracle::receiver& r) { return points.occlusion(p, r, s); });
    oracle::check_within(oracle::compare(oracle::run(p, composed->view(), how), expected),
                         oracle::of_rounding);
}
