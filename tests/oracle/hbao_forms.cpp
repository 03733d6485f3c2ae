// SPDX-License-Identifier: MIT
// HBAO's occlusion of scenes where it follows from their geometry.
#include "run.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace {

using oracle::lens;
using kind = oracle::surface::kind;

constexpr int slices = 32, steps = 64;

/// HBAO's sum over the surfaces themselves: in each slice the horizon, raised from the tangent plane's angle
/// by what the rays beside the receiver's meet, each rise of its sine weighed by the distance; the mean over
/// offsets of the first step.
double occlusion_of(const oracle::picture& p, const std::vector<oracle::surface>& scene,
                    const oracle::receiver& r, double radius, double bias) {
    const int offsets = 16;
    glm::dvec3 across, up;
    oracle::axes(p, r, across, up);
    double occlusion = 0;
    for (int i = 0; i < slices * offsets; ++i) {
        const double angle = 2 * glm::pi<double>() * (i + 0.5) / (slices * offsets);
        const glm::dvec3 azimuth = std::cos(angle) * across + std::sin(angle) * up;
        const glm::dvec2 centre(r.x + 0.5, r.y + 0.5), whole = oracle::texel_offset(p, r, radius * azimuth);
        const glm::dvec2 reach = whole * oracle::share_inside(p, centre, whole);
        const double tangent = oracle::tangent_angle(r, azimuth);
        double highest = std::sin(tangent + bias);
        for (int step = 0; step < steps; ++step) {
            const double u = (step + (i % offsets + 0.5) / offsets) / steps;
            glm::dvec3 origin, direction, position, normal;
            p.ray(centre + reach * (u * u + 1 / glm::length(reach)), origin, direction);
            if (!oracle::first_hit(scene, origin, direction, position, normal))
                continue;
            const glm::dvec3 v = position - r.position;
            const double towards = glm::dot(v, r.to_eye), share = glm::length(v) / radius,
                         sine = std::sin(std::atan2(towards, glm::length(v - towards * r.to_eye)));
            if (share < 1 && sine > highest) {
                occlusion += (1 - share * share) * (sine - highest) / (slices * offsets);
                highest = sine;
            }
        }
    }
    return occlusion;
}

/// The visibility that `directions:32x64` gives all pixels, its strength 1.
std::vector<float> run(const oracle::picture& p, const std::string& parts, double radius, double bias) {
    const std::string text = fmt::format("directions:{}x{}/single_layer/hbao{}", slices, steps, parts);
    const auto composed = oracle::compose(text);
    crease::parameters how = oracle::view_parameters(p, composed->view(), radius);
    oracle::set(how, composed->view(), "strength", 1);
    oracle::set(how, composed->view(), "bias", bias);
    return oracle::run(p, composed->view(), how);
}

}

TEST_CASE("floor by a wall, under an overhang, beside a step at a slant, in a sphere: by HBAO's sum") {
    struct example {
        std::string name;
        std::vector<oracle::surface> scene;
        lens of;
        double radius;
        std::vector<glm::ivec2> pixels;
        double least_occlusion; ///< of them all, so that none is a plane's
    };
    const glm::dvec3 tilted(std::sin(0.6), 0, std::cos(0.6));
    const example examples[] = {
        {"a floor by a wall",
         {{kind::plane, {0, -1, 0}, {0, 1, 0}}, {kind::plane, {0, 0, -4}, {0, 0, 1}}},
         lens::standard,
         1.0,
         {{200, 190}, {150, 196}, {260, 197}},
         0.1},
        // Taps above the receiver lean from its normal towards the eye.
        {"a floor under an overhang",
         {{kind::plane, {0, -0.5, 0}, {0, 1, 0}}, {kind::plane, {0, 0.2, 0}, {0, -1, 0}}},
         lens::standard,
         1.6,
         {{200, 180}, {200, 172}, {120, 176}},
         0.1},
        {"a floor by a wall, with a radius far larger than the picture",
         {{kind::plane, {0, -1, 0}, {0, 1, 0}}, {kind::plane, {0, 0, -4}, {0, 0, 1}}},
         lens::standard,
         1000.0,
         {{200, 190}, {150, 210}, {260, 250}},
         0.1},
        {"beside a step at a slant",
         {{kind::plane, {0, 0, -4}, tilted}, {kind::half_plane, glm::dvec3(0, 0, -4) + 0.4 * tilted, tilted}},
         lens::orthographic,
         0.9,
         {{205, 133}, {207, 60}, {200, 200}},
         0.05},
        {"the inside of a sphere",
         {{kind::inside_of_sphere, {0, 0, -3}, {}, 2}},
         lens::standard,
         1.2,
         {{200, 133}, {130, 133}, {280, 70}},
         0.02},
    };
    const double bias = 0.15;
    for (const example& e : examples) {
        const oracle::picture p = oracle::draw(e.scene, e.of, 401, 267);
        const std::vector<float> image =
            run(p, e.of == lens::orthographic ? "/orthographic" : "", e.radius, bias);
        for (const glm::ivec2 at : e.pixels) {
            CAPTURE(e.name);
            CAPTURE(at.x);
            CAPTURE(at.y);
            oracle::receiver r{
                at.x, at.y, at.x, at.y, p.position(at.x, at.y), glm::dvec3(p.normals[p.index(at.x, at.y)]),
                {}};
            r.to_eye = p.to_eye(r.position);
            const double occlusion = occlusion_of(p, e.scene, r, e.radius, bias);
            CHECK(occlusion > e.least_occlusion);
            CHECK(std::abs(image[p.index(at.x, at.y)] - (1 - occlusion)) < 0.015);
        }
    }
}

TEST_CASE("the inside of a sphere, by HBAO's integral") {
    // A chord of length r from a point of a sphere of radius s rises by asin(r / 2 s) over the tangent plane,
    // so along each direction the occlusion is the integral of W(r) = 1 - (r / R)^2 over d sin = dr / 2 s,
    // from the bias to R.
    const double s = 2, radius = 1.2, bias = 0.15;
    const oracle::picture p =
        oracle::draw({{kind::inside_of_sphere, {0, 0, -3}, {}, s}}, lens::standard, 257, 181);
    const double first = 2 * s * std::sin(bias);
    const auto integral = [&](double r) { return (r - r * r * r / (3 * radius * radius)) / (2 * s); };
    const double expected = 1 - (integral(radius) - integral(first));
    CHECK(std::abs(run(p, "", radius, bias)[p.index(128, 90)] - expected) < 0.006);
}

TEST_CASE("beside a step, by HBAO's integral") {
    // Orthographic, floor and step face the eye: in each direction that meets the step of height h at
    // distance d, the horizon jumps to its edge, at r = sqrt(d^2 + h^2), and falls behind it.
    const double height = 0.4, radius = 0.9, bias = 0.15;
    const oracle::picture p = oracle::draw(
        {{kind::plane, {0, 0, -4}, {0, 0, 1}}, {kind::half_plane, {0, 0, -4 + height}, {0, 0, 1}}},
        lens::orthographic, 400, 267);
    const auto composed = oracle::compose("directions:64x64/single_layer/hbao/orthographic");
    crease::parameters how = oracle::view_parameters(p, composed->view(), radius);
    oracle::set(how, composed->view(), "strength", 1);
    oracle::set(how, composed->view(), "bias", bias);
    const std::vector<float> image = oracle::run(p, composed->view(), how);
    for (int x : {120, 150, 170, 190}) {
        const double distance = -p.position(x, 133).x;
        double occlusion = 0;
        const int arcs = 4000;
        for (int i = 0; i < arcs; ++i) {
            const double angle = 2 * 3.14159265358979 * (i + 0.5) / arcs;
            const double along = distance / std::cos(angle);
            const double r = std::sqrt(along * along + height * height);
            if (std::cos(angle) > 0 && r < radius)
                occlusion +=
                    (1 - r * r / (radius * radius)) * std::max(height / r - std::sin(bias), 0.0) / arcs;
        }
        CAPTURE(distance);
        CHECK(std::abs(image[p.index(x, 133)] - (1 - occlusion)) < 0.015);
    }
}
