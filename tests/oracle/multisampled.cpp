// SPDX-License-Identifier: MIT
// What the samples of a multisampled image keep at the edge of a triangle: those that it covers its depth at
// the texel's centre, also where that lies beside it, and the others what is behind.
#include "captured.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace {

using oracle::lens;

constexpr int width = 64, height = 48;

/// Vulkan's standard places of 4 samples in a texel.
const glm::dvec2 places[] = {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};

/// A triangle that is slanted in depth, over a wall behind it.
const oracle::triangles slanted{{-1.3f, -0.9f, -4}, {1.6f, -0.2f, -2.5f}, {-0.2f, 1.1f, -3}};
constexpr float wall_depth = 6;

bool has_samples() {
    const bool there = (oracle::device().features().depth_samples & 4) != 0;
    if (!there)
        MESSAGE("the device lacks depth images of 4 samples: multisampled is not tested on it");
    return there;
}

/// The picture in whose texels the triangle is.
oracle::picture seen_by(lens kind) {
    oracle::picture p;
    p.width = width;
    p.height = height;
    p.projection = oracle::make_projection(kind, double{width} / height);
    p.reversed = kind == lens::reversed;
    return p;
}

/// Twice the area that a point makes with an edge on the screen.
double side_of(glm::dvec2 a, glm::dvec2 b, glm::dvec2 point) {
    return (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x);
}

/// How far inside of the triangle a point of the screen is, in texels; negative outside.
double inside(const oracle::picture& p, glm::dvec2 point) {
    glm::dvec2 corners[3];
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = p.project(glm::dvec3(slanted[i]));
    const double turn = side_of(corners[0], corners[1], corners[2]) > 0 ? 1 : -1;
    double least = 1e9;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec2 a = corners[i], b = corners[(i + 1) % 3];
        least = std::min(least, turn * side_of(a, b, point) / glm::length(b - a));
    }
    return least;
}

/// Linear depth of the triangle's plane on the ray through a point of the screen.
double depth_at(const oracle::picture& p, glm::dvec2 point) {
    glm::dvec3 origin, direction;
    p.ray(point, origin, direction);
    const glm::dvec3 a(slanted[0]),
        normal = glm::cross(glm::dvec3(slanted[1]) - a, glm::dvec3(slanted[2]) - a);
    return -(origin + direction * (glm::dot(a - origin, normal) / glm::dot(direction, normal))).z;
}

/// The layers of each texel that are left after packing, nearest first.
std::vector<std::vector<double>> packed(oracle::layer_capture& capture) {
    const std::vector<float> four = capture.runner().download("packed_layers");
    std::vector<std::vector<double>> layers;
    for (std::size_t i = 0; i < four.size(); i += 4) {
        layers.emplace_back();
        for (std::size_t j = i; j < i + 4 && four[j] < 1e14f; ++j)
            layers.back().push_back(double{four[j]});
        std::ranges::sort(layers.back());
    }
    return layers;
}

bool near(double a, double b) {
    return std::abs(a - b) < 2e-4 * b;
}

}

TEST_CASE(
    "multisampled: the samples beside a triangle keep what is behind it, and its depth is the centre's") {
    if (!has_samples())
        return;
    for (lens kind : {lens::standard, lens::reversed})
        for (unsigned samples : {3u, 4u}) {
            CAPTURE(static_cast<int>(kind));
            CAPTURE(samples);
            const oracle::picture p = seen_by(kind);
            oracle::layer_capture capture("multisampled/stratified", samples, width, height, kind,
                                          "pack_layers");
            oracle::triangles scene = slanted; // first, so that it is the depth test that keeps it
            for (glm::vec3 corner : oracle::wall(wall_depth))
                scene.push_back(corner);
            capture.draw(scene, {.opacity = 1});
            const auto layers = packed(capture);
            std::size_t beside_centre = 0, divided = 0;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    unsigned covered = 0;
                    bool unsure = false;
                    for (unsigned s = 0; s < samples; ++s) {
                        const double in = inside(p, glm::dvec2(x, y) + places[s]);
                        covered += in > 0;
                        unsure = unsure || std::abs(in) < 0.01; // texels; a rasteriser snaps corners to 1/256
                    }
                    if (unsure)
                        continue;
                    const glm::dvec2 centre(x + 0.5, y + 0.5);
                    const std::vector<double>& found = layers[p.index(x, y)];
                    CAPTURE(x);
                    CAPTURE(y);
                    REQUIRE(found.size() == (covered > 0) + std::size_t{covered < samples});
                    if (covered > 0)
                        CHECK(near(found.front(), depth_at(p, centre)));
                    if (covered < samples)
                        CHECK(near(found.back(), double{wall_depth}));
                    beside_centre += covered > 0 && inside(p, centre) < 0;
                    divided += covered > 0 && covered < samples;
                }
            CHECK(beside_centre > 10); // the depth there is that of the plane beside the triangle
            CHECK(divided > 30);
        }
}

TEST_CASE("multisampled: where nothing is drawn no sample keeps anything") {
    if (!has_samples())
        return;
    for (lens kind : {lens::standard, lens::reversed}) {
        const oracle::picture p = seen_by(kind);
        oracle::layer_capture capture("multisampled/stratified", 4, width, height, kind, "pack_layers");
        capture.draw(slanted, {.opacity = 1});
        const auto layers = packed(capture);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (inside(p, {x + 0.5, y + 0.5}) < -1)
                    CHECK(layers[p.index(x, y)].empty());
    }
}

TEST_CASE("multisampled: samples keep fragments by the coverage, with the depth test of the host") {
    if (!has_samples())
        return;
    for (lens kind : {lens::standard, lens::reversed}) {
        CAPTURE(static_cast<int>(kind));
        oracle::layer_capture capture("multisampled/simple_hash", 4, width, height, kind, "pack_layers");
        oracle::triangles scene = oracle::wall(4);
        for (glm::vec3 corner : oracle::wall(2))
            scene.push_back(corner);
        capture.draw(scene, {.opacity = 0.4f});
        double near_kept = 0, far_kept = 0;
        for (const std::vector<double>& found : packed(capture))
            for (double depth : found) {
                near_kept += near(depth, 2);
                far_kept += near(depth, 4);
            }
        // A layer is in a texel where at least one of 4 samples keeps it.
        const double texels = width * height, of_near = 1 - std::pow(0.6, 4),
                     of_far = 1 - std::pow(1 - 0.24, 4);
        CHECK(std::abs(near_kept / texels - of_near) < 5 * std::sqrt(of_near * (1 - of_near) / texels));
        CHECK(std::abs(far_kept / texels - of_far) < 5 * std::sqrt(of_far * (1 - of_far) / texels));
    }
}

TEST_CASE("one sample keeps the nearest fragment, with either direction of depth") {
    for (lens kind : {lens::standard, lens::reversed, lens::infinite, lens::orthographic}) {
        CAPTURE(static_cast<int>(kind));
        oracle::layer_capture capture("atomic_minimum", 1, width, height, kind);
        oracle::triangles scene = oracle::wall(4);
        for (float depth : {2.0f, 3.0f})
            for (glm::vec3 corner : oracle::wall(depth))
                scene.push_back(corner);
        capture.draw(scene, {.opacity = 1});
        for (std::uint32_t bits : capture.runner().download_uint("captured_layers"))
            REQUIRE(near(std::bit_cast<float>(bits), 2));
    }
}
