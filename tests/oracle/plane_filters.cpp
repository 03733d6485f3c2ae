// SPDX-License-Identifier: MIT
// Filters over pictures whose visibility is known: each surface has its own.
#include "run.hpp"

#include <doctest/doctest.h>

#include <array>

#include <algorithm>
#include <cmath>

namespace {

using kind = oracle::surface::kind;
using oracle::lens;

// In place of an estimate, a visibility by the normal: 1 where it looks up more than to the eye, else 0; or a
// chequerboard.
constexpr crease::glsl_file by_surface_glsl{"test/by_surface.glsl", R"glsl(
crease_result crease_evaluate(ivec2 pixel) {
    vec2 texel = crease_texel_of_pixel(pixel, crease_divisor);
    float depth = crease_depth_at(texel);
    if (!(depth < crease_background))
        return crease_open_result();
    vec3 normal = crease_normal_at(texel, crease_view_position(texel, depth));
    crease_result result = crease_open_result();
    result.visibility = crease_by_surface_how == 0 ? float(normal.y > normal.z)
                                                   : crease_by_surface_how == 1 ? float(depth > 3.0)
                                                                                : float((pixel.x + pixel.y) % 2);
    result.depth = depth;
    result.normal = normal;
    return result;
}
)glsl"};

struct by_surface {
    static constexpr crease::number takes[] = {{"how", 0, 2, 0, "normal, depth, chequerboard"}};
    static constexpr const crease::glsl_file* files[] = {&by_surface_glsl};
    static constexpr crease::part description{.kind = crease::role::receivers,
                                              .name = "by_surface",
                                              .summary = "",
                                              .source = "",
                                              .files = files,
                                              .numbers = takes};
};

enum visibility { by_normal, by_depth, chequered };

std::vector<float> filtered(const oracle::picture& p, visibility how, const std::string& filters,
                            double radius) {
    static constexpr auto known = [] {
        std::array<const crease::part*, std::size(crease::all_parts) + 1> all{&by_surface::description};
        std::copy(std::begin(crease::all_parts), std::end(crease::all_parts), all.begin() + 1);
        return all;
    }();
    const crease::recipe chosen(
        "directions/single_layer/hbao/r32f/by_surface:" + std::to_string(how) + filters, known);
    REQUIRE_MESSAGE(static_cast<bool>(chosen), chosen.error());
    const auto composed = std::make_unique<crease::composition>(chosen);
    return oracle::run(p, *composed, oracle::view_parameters(p, *composed, radius));
}

const std::string all_filters[] = {"/plane_filter:2",           "/plane_filter:3",
                                   "/separable_plane_filter:3", "/plane_filter:2/reconstructed_normals",
                                   "/plane_filter:2/fragment",  "/plane_filter:2/image_load"};

}

TEST_CASE("what a surface has does not leak to another: beside a crease, and over an edge") {
    // A radius that reaches less than a pixel over the crease.
    const oracle::picture crease =
        oracle::draw({{kind::plane, {0, -0.5, 0}, {0, 1, 0}}, {kind::plane, {0, 0, -3}, {0, 0, 1}}},
                     lens::standard, 81, 63);
    // A step of 8 reaches between planes that are parallel.
    const oracle::picture edge =
        oracle::draw({{kind::half_plane, {0, 0, -2.8}, {0, 0, 1}}, {kind::plane, {0, 0, -3.2}, {0, 0, 1}}},
                     lens::standard, 81, 63);
    for (const std::string& filters : all_filters) {
        CAPTURE(filters);
        const std::vector<float> at_crease = filtered(crease, by_normal, filters, 0.01);
        const std::vector<float> at_edge = filtered(edge, by_depth, filters, 1);
        for (int y = 0; y < crease.height; ++y)
            for (int x = 0; x < crease.width; ++x) {
                const std::size_t i = crease.index(x, y);
                // Reconstructed normals of the row beside the crease may be of either.
                const bool is_floor = crease.normals[i].y > 0.5f;
                const bool is_apart = y > 0 && y + 1 < crease.height &&
                                      (crease.normals[crease.index(x, y - 1)].y > 0.5f) == is_floor &&
                                      (crease.normals[crease.index(x, y + 1)].y > 0.5f) == is_floor;
                if (is_apart || filters.find("reconstructed") == std::string::npos)
                    REQUIRE(std::abs(at_crease[i] - (is_floor ? 1 : 0)) < 0.01f);
                REQUIRE(at_edge[i] == (edge.position(x, y).z < -3 ? 1 : 0));
            }
    }
}

TEST_CASE("upsampled, a surface has what its own pixels have, but for the crease's reach") {
    for (int factor : {2, 3, 4}) {
        CAPTURE(factor);
        const oracle::picture edge = oracle::draw(
            {{kind::half_plane, {0, 0, -2.8}, {0, 0, 1}}, {kind::plane, {0, 0, -3.2}, {0, 0, 1}}},
            lens::standard, 81, 63);
        const std::string filters = "/upsample:" + std::to_string(factor);
        const std::vector<float> image = filtered(edge, by_depth, filters, 1);
        for (std::size_t i = 0; i < image.size(); ++i) {
            const int x = static_cast<int>(i) % edge.width, y = static_cast<int>(i) / edge.width;
            REQUIRE(std::abs(image[i] - (edge.position(x, y).z < -3 ? 1 : 0)) < 0.001f);
        }
    }
}

TEST_CASE(
    "a plane at any slant gets the whole of a filter, near and far, and keeps what is the same everywhere") {
    for (double degrees : {0.0, 40.0, 70.0, 85.0})
        for (double distance : {0.5, 20.0})
            for (const std::string& filters : all_filters) {
                CAPTURE(degrees);
                CAPTURE(distance);
                CAPTURE(filters);
                const double a = degrees * 3.14159265358979 / 180;
                const oracle::picture p = oracle::draw(
                    {{kind::plane, {0, 0, -distance}, {std::sin(a) * 0.8, std::sin(a) * 0.6, std::cos(a)}}},
                    lens::standard, 64, 48);
                const std::vector<float> half = filtered(p, chequered, filters, 0.2 * distance);
                const std::vector<float> whole = filtered(p, by_normal, filters, 0.2 * distance);
                for (int y = 8; y + 8 < p.height; ++y)
                    for (int x = 8; x + 8 < p.width; ++x) {
                        const bool all_there = !p.background(x - 4, y - 4) && !p.background(x + 4, y - 4) &&
                                               !p.background(x - 4, y + 4) && !p.background(x + 4, y + 4);
                        if (all_there)
                            REQUIRE(std::abs(half[p.index(x, y)] - 0.5f) < 0.02f);
                        if (!p.background(x, y))
                            REQUIRE(whole[p.index(x, y)] == whole[p.index(p.width / 2, p.height / 2)]);
                    }
            }
}

TEST_CASE("background stays open beside what is closed, and surfaces of a pixel among it stay finite") {
    oracle::picture p = oracle::draw({{kind::half_plane, {0, 0, -2}, {0, 0, 1}}}, lens::standard, 41, 31);
    for (int y = 2; y < p.height; y += 5)
        for (int x = 1; x < 20; x += 5) { // alone in the background
            p.device[p.index(x, y)] = p.device[p.index(40, 10)];
            p.normals[p.index(x, y)] = {0, 0, 1};
        }
    for (const char* filters : {"/plane_filter:2", "/separable_plane_filter:3", "/upsample:2", "/upsample:4",
                                "/plane_filter/upsample:2", "/upsample:4/plane_filter"})
        for (double radius : {1e-6, 1.0, 1e6, 1e20}) {
            CAPTURE(std::string(filters));
            CAPTURE(radius);
            const std::vector<float> image = filtered(p, by_depth, filters, radius);
            for (int y = 0; y < p.height; ++y)
                for (int x = 0; x < p.width; ++x) {
                    const float v = image[p.index(x, y)];
                    REQUIRE((v >= 0 && v <= 1));
                    if (p.background(x, y))
                        REQUIRE(v == 1);
                    else if (x > 30)
                        REQUIRE(v == 0);
                }
        }
}

TEST_CASE("the bilateral filter takes no texel beyond the picture's edge") {
    const oracle::picture p = oracle::draw({{kind::plane, {0, 0, -3}, {0, 0, 1}}}, lens::standard, 24, 17);
    for (int radius : {1, 2, 3}) {
        CAPTURE(radius);
        // What the Gaussian leaves of a chequerboard along a row or a column.
        const auto contrast = [radius](int at, int size) {
            double sum = 0, weights = 0;
            for (int i = std::max(-radius, -at); i <= std::min(radius, size - 1 - at); ++i) {
                const double weight = std::exp2(-2.0 * i * i / (radius * radius));
                sum += i % 2 == 0 ? weight : -weight;
                weights += weight;
            }
            return sum / weights;
        };
        const std::vector<float> found = filtered(p, chequered, "/bilateral:" + std::to_string(radius), 1);
        for (int y = 0; y < p.height; ++y)
            for (int x = 0; x < p.width; ++x) {
                const double own = (x + y) % 2 == 0 ? -0.5 : 0.5;
                REQUIRE(std::abs(found[p.index(x, y)] -
                                 (0.5 + own * contrast(x, p.width) * contrast(y, p.height))) <
                        0.006); // 8 bits twice
            }
    }
}
