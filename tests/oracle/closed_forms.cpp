// SPDX-License-Identifier: MIT
// Scenes whose answer is known without sampling.
#include "run.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace {

using oracle::lens;
using kind = oracle::surface::kind;

const char* const recipes[] = {"hemisphere_points:16/single_layer/ssao",
                               "directions:8x4/single_layer/hbao",
                               "directions:8x4/single_layer/hbao_plus",
                               "poisson_disk:16/single_layer/hbao_plus",
                               "hemisphere_points:16/single_layer/point_volume",
                               "sphere_points:16/single_layer/point_volume",
                               "sphere_points:16/single_layer/ssao",
                               "hemisphere_lines:12/single_layer/line_volume",
                               "sphere_lines:12/single_layer/line_volume",
                               "sample_box/summed_area/mean_height",
                               "sample_box/summed_area_uniform:5x2/mean_height",
                               "sample_box/summed_area_adaptive:4x2/mean_height"};

float least(const std::vector<float>& image) {
    return *std::min_element(image.begin(), image.end());
}

}

TEST_CASE("a plane is unoccluded at every slant, near and far, also with reconstructed normals") {
    for (const char* recipe : recipes)
        for (double degrees : {0.0, 30.0, 60.0, 75.0, 80.0})
            for (double distance : {0.5, 3.0, 20.0})
                for (const char* normals : {"", "/reconstructed_normals"}) {
                    CAPTURE(std::string(recipe));
                    CAPTURE(degrees);
                    CAPTURE(distance);
                    CAPTURE(std::string(normals));
                    const double a = degrees * 3.14159265358979 / 180;
                    for (glm::dvec3 normal :
                         {glm::dvec3(std::sin(a), 0, std::cos(a)), glm::dvec3(0, std::sin(a), std::cos(a))}) {
                        const oracle::picture p =
                            oracle::draw({{kind::plane, {0, 0, -distance}, normal}}, lens::standard, 96, 64);
                        CHECK(least(oracle::run(p, std::string(recipe) + normals, 0.3 * distance)) >= 0.995f);
                    }
                }
}

TEST_CASE("a radius of 0 occludes nothing, and a huge one gives finite values") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 48, 32);
    for (const char* recipe : recipes) {
        CAPTURE(std::string(recipe));
        CHECK(least(oracle::run(p, recipe, 0)) == 1.0f);
        for (const char* filters : {"/bilateral", "/plane_filter/upsample:2"}) {
            for (float v : oracle::run(p, std::string(recipe) + filters, 1e6))
                CHECK((v >= 0 && v <= 1));
            CHECK(least(oracle::run(p, std::string(recipe) + filters, 0)) == 1.0f);
        }
    }
}

TEST_CASE("odd sizes") {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), {7, 5}, {641, 359}, {1, 9}, {16, 1}})
        for (const char* filters : {"", "/bilateral", "/upsample:2", "/bilateral/upsample:4", "/plane_filter",
                                    "/separable_plane_filter/upsample:4"}) {
            CAPTURE(size.x);
            CAPTURE(size.y);
            CAPTURE(std::string(filters));
            const oracle::picture p = oracle::draw({{kind::plane, {0, 0, -2}, {0, 0.5, 0.8660254}}},
                                                   lens::standard, size.x, size.y);
            for (const char* stage : {"", "/compute_columns:8x8x3", "/fragment"}) {
                CAPTURE(std::string(stage));
                const auto image = oracle::run(p, std::string(recipes[1]) + filters + stage, 0.5);
                CHECK(image.size() == p.device.size());
                CHECK(least(image) >= 0.995f);
            }
        }
}

TEST_CASE("NaN, infinite and zero depth darken nothing around them") {
    oracle::picture p = oracle::draw({{kind::plane, {0, 0, -2}, {0, 0, 1}}}, lens::standard, 40, 30);
    const float bad[] = {std::nanf(""), std::numeric_limits<float>::infinity(), 1.0f};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            p.device[p.index(5 + 9 * static_cast<int>(i), 4 + static_cast<int>(j) * 6)] = bad[i];
    for (const char* recipe : recipes)
        for (const char* parts :
             {"", "/reconstructed_normals", "/bilateral", "/bilateral/upsample:2",
              "/plane_filter/reconstructed_normals", "/separable_plane_filter/upsample:2"}) {
            CAPTURE(std::string(recipe));
            CAPTURE(parts);
            for (float v : oracle::run(p, std::string(recipe) + parts, 0.5))
                CHECK(v >= 0.99f);
        }
}

TEST_CASE("every sampler finds what is in the picture, however large the radius") {
    // A corner of a floor and two walls: of what is open at all, the rays leave through the picture's edges.
    const oracle::picture p = oracle::draw({{kind::plane, {0, -1, 0}, {0, 1, 0}},
                                            {kind::plane, {0, 0, -4}, {0, 0, 1}},
                                            {kind::plane, {-1.2, 0, 0}, {1, 0, 0}}},
                                           lens::standard, 161, 107);
    for (const char* recipe :
         {"directions:4x4/single_layer/hbao", "directions:4x4/single_layer/hbao_plus",
          "poisson_disk:16/single_layer/hbao_plus", "hemisphere_points:16/single_layer/ssao",
          "hemisphere_points:16/single_layer/point_volume", "sphere_points:17/single_layer/point_volume"}) {
        CAPTURE(std::string(recipe));
        const auto mean = [&](double radius) {
            const std::vector<float> image = oracle::run(p, recipe, radius);
            return std::accumulate(image.begin(), image.end(), 0.0) / static_cast<double>(image.size());
        };
        const double large = mean(50);
        CHECK(large < 0.9);
        CHECK(std::abs(mean(1000) - large) < 0.005);
    }
}
