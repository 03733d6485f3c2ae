// SPDX-License-Identifier: MIT
#include "truth/truth.hpp"

#include "before_wall.hpp"
#include "expect_error.hpp"
#include "measure/compare.hpp"
#include "placed_scene.hpp"
#include "scene/solids.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace crease::tools;

namespace {

constexpr float far_away = 500;

camera look(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up = {0, 1, 0}) {
    camera from;
    from.eye = eye;
    from.target = target;
    from.up = up;
    return from;
}

void add_rectangle(mesh& to, const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b) {
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    to.positions.insert(to.positions.end(), {corner, corner + a, corner + a + b, corner + b});
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u})
        to.indices.push_back(first + i);
}

/// The ground at y = 0 around `centre`.
mesh ground(const glm::dvec3& centre = glm::dvec3(0)) {
    mesh plane;
    add_rectangle(plane, centre + glm::dvec3(-far_away, 0, -far_away), {2 * far_away, 0, 0},
                  {0, 0, 2 * far_away});
    return plane;
}

/// World-space position that a texel of the truth shows.
glm::dvec3 position(const truth& seen, const camera& from, unsigned x, unsigned y) {
    const double half = std::tan(glm::radians(double{from.vfov_deg}) / 2);
    const double width = seen.depth.width, height = seen.depth.height;
    const glm::dvec3 through(half * width / height * ((x + 0.5) / width * 2 - 1),
                             half * (1 - (y + 0.5) / height * 2), -1);
    return glm::inverse(view_matrix(from)) * glm::dvec4(through * double{seen.depth.at(x, y)}, 1);
}

glm::dvec3 world_normal(const truth& seen, const camera& from, unsigned x, unsigned y) {
    const glm::dvec3 normal(seen.normal.at(x, y, 0), seen.normal.at(x, y, 1), seen.normal.at(x, y, 2));
    return glm::transpose(view_rotation(from)) * normal;
}

bool all_are(const image& pixels, float value) {
    return std::ranges::all_of(pixels.texels, [=](float texel) { return texel == value; });
}

double mean(const image& pixels) {
    double sum = 0;
    for (const float texel : pixels.texels)
        sum += texel;
    return sum / static_cast<double>(pixels.texels.size());
}

}

TEST_CASE("truth: a plane is open, near the origin and far from it") {
    for (const glm::vec3 centre : {glm::vec3(0), glm::vec3(10000, 3000, -20000)}) {
        const camera from = look(centre + glm::vec3(0, 5, 8), centre);
        const truth seen =
            trace_truth(ground(centre), from, {.width = 64, .height = 36, .radius = 50, .rays = 256});
        CHECK(all_are(seen.ao_hard, 1));
        CHECK(all_are(seen.ao_linear, 1));
        CHECK(all_are(seen.ao_quad, 1));
        for (unsigned y = 0; y < 36; ++y)
            for (unsigned x = 0; x < 64; ++x) {
                REQUIRE(seen.depth.at(x, y) < from.far);
                REQUIRE(std::abs(position(seen, from, x, y).y - centre.y) <
                        1e-6f * glm::length(centre) + 1e-4f);
                REQUIRE(glm::distance(world_normal(seen, from, x, y), {0, 1, 0}) < 1e-5f);
            }
    }
}

TEST_CASE("truth: a floor before a wall has the visibility of the closed form") {
    mesh corner = ground();
    add_rectangle(corner, {0, 0, -far_away}, {0, 0, 2 * far_away}, {0, far_away, 0});
    constexpr float radius = 2;
    const camera from = look({2.2f, 4, 0}, {1.2f, 0, 0}, {0, 0, -1});
    const truth seen = trace_truth(corner, from, {.width = 64, .height = 36, .radius = radius, .rays = 1024});
    unsigned floor_texels = 0, open_texels = 0;
    for (unsigned y = 0; y < 36; ++y)
        for (unsigned x = 0; x < 64; ++x) {
            if (world_normal(seen, from, x, y).y < 0.9f)
                continue;
            const visibility expected = before_wall(double{position(seen, from, x, y).x} / radius);
            REQUIRE(std::abs(seen.ao_hard.at(x, y) - expected.hard) < 0.008);
            REQUIRE(std::abs(seen.ao_linear.at(x, y) - expected.linear) < 0.004);
            REQUIRE(std::abs(seen.ao_quad.at(x, y) - expected.quad) < 0.004);
            ++floor_texels;
            open_texels += expected.hard == 1;
        }
    CHECK(floor_texels > 1000);
    CHECK(open_texels > 100);
}

TEST_CASE("truth: inside of a sphere") {
    std::vector<glm::vec2> profile;
    for (unsigned i = 0; i <= 64; ++i) {
        const double angle = std::numbers::pi * i / 64;
        profile.emplace_back(i % 64 == 0 ? 0 : std::sin(angle), -std::cos(angle));
    }
    mesh sphere;
    add_lathe(sphere, profile, 128, glm::mat4(1));
    const camera from = look({0, 0, 0}, {1, 0.2f, 0.3f});
    const auto inside = [&](float radius) {
        return trace_truth(sphere, from, {.width = 40, .height = 30, .radius = radius, .rays = 256});
    };
    // A ray at the angle t to the normal hits at distance 2 cos(t); the mean of cos is 2/3, that of its
    // square 1/2.
    const truth whole = inside(2);
    CHECK(mean(whole.ao_hard) == doctest::Approx(0).epsilon(1e-6));
    CHECK(mean(whole.ao_linear) == doctest::Approx(2.0 / 3).epsilon(0.002));
    CHECK(mean(whole.ao_quad) == doctest::Approx(0.5).epsilon(0.002));
    // Within half of that are the angles over 60 degrees, which weigh a quarter.
    CHECK(mean(inside(1).ao_hard) == doctest::Approx(0.75).epsilon(0.002));
}

TEST_CASE("truth: inside of a box all is closed, whichever way its triangles wind") {
    mesh box;
    add_box(box, {-1, -1, -1}, {1, 1, 1});
    const camera from = look({0.3f, 0.1f, 0.2f}, {1, 0.7f, -1});
    const truth_settings settings{.width = 48, .height = 48, .radius = 100, .rays = 64};
    const truth seen = trace_truth(box, from, settings);
    CHECK(all_are(seen.ao_hard, 0));
    for (std::size_t i = 0; i < box.indices.size(); i += 3)
        std::swap(box.indices[i], box.indices[i + 1]);
    const truth turned = trace_truth(box, from, settings);
    CHECK(all_are(turned.ao_hard, 0));
    for (unsigned y = 0; y < 48; ++y)
        for (unsigned x = 0; x < 48; ++x) {
            CHECK(std::abs(seen.depth.at(x, y) - turned.depth.at(x, y)) < 1e-5f);
            CHECK(glm::distance(world_normal(seen, from, x, y), world_normal(turned, from, x, y)) < 1e-5f);
        }
}

TEST_CASE("truth: row 0 is at the top, column 0 on the left, and background is far and open") {
    mesh patch;
    add_rectangle(patch, {-4, 0, -5}, {4, 0, 0}, {0, 4, 0}); // the upper left quarter of the view
    const truth seen = trace_truth(patch, look({0, 0, 0}, {0, 0, -1}), {.width = 8, .height = 6, .rays = 4});
    for (unsigned y = 0; y < 6; ++y)
        for (unsigned x = 0; x < 8; ++x) {
            const bool hit = x < 4 && y < 3;
            CHECK(seen.depth.at(x, y) == doctest::Approx(hit ? 5 : 100));
            CHECK(seen.normal.at(x, y, 2) == (hit ? 1 : 0));
            CHECK(seen.ao_hard.at(x, y) == 1);
        }
}

TEST_CASE("truth: near and far clip what is seen, not what occludes") {
    mesh layers;
    add_rectangle(layers, {-9, -9, -1}, {18, 0, 0}, {0, 18, 0});
    add_rectangle(layers, {-9, -9, -2}, {18, 0, 0}, {0, 18, 0});
    camera from = look({0, 0, 0}, {0, 0, -1});
    const truth_settings settings{.width = 4, .height = 4, .radius = 100, .rays = 64};
    from.near = 1.5f;
    const truth second = trace_truth(layers, from, settings);
    CHECK(mean(second.depth) == doctest::Approx(2));
    CHECK(mean(second.ao_hard) < 0.1);
    from.far = 1.9f;
    const truth none = trace_truth(layers, from, settings);
    CHECK(all_are(none.depth, 1.9f));
    CHECK(all_are(none.ao_hard, 1));
}

TEST_CASE("truth: radius 0 is open") {
    mesh box;
    add_box(box, {-1, -1, -1}, {1, 1, 1});
    const truth seen =
        trace_truth(box, look({0, 0, 0}, {1, 0, 0}), {.width = 8, .height = 8, .radius = 0, .rays = 8});
    CHECK(all_are(seen.ao_hard, 1));
    CHECK(all_are(seen.ao_linear, 1));
    CHECK(all_are(seen.ao_quad, 1));
}

TEST_CASE("truth: the seed decides, not the number of threads") {
    const mesh scene = built_in_scene();
    const camera from = built_in_cameras()[0];
    const auto visibility_of = [&](std::uint32_t seed, unsigned threads) {
        const truth_settings settings{.width = 64,
                                      .height = 36,
                                      .radius = from.ao_radius,
                                      .rays = 16,
                                      .seed = seed,
                                      .threads = threads};
        return trace_truth(scene, from, settings).ao_linear.texels;
    };
    const std::vector<float> one = visibility_of(1, 1);
    CHECK(one == visibility_of(1, 5));
    CHECK(one == visibility_of(1, 0));
    CHECK(one != visibility_of(2, 1));
}

TEST_CASE("truth: progress rises to 1, on the caller's thread, and may cancel") {
    struct asked_to_fail {};
    const mesh scene = ground();
    const camera from = look({0, 5, 8}, {0, 0, 0});
    truth_settings settings{.width = 16, .height = 200, .radius = 1, .rays = 16, .threads = 3};
    double last = 0;
    settings.progress = [&](double fraction) {
        CHECK(fraction >= last);
        last = fraction;
        return true;
    };
    trace_truth(scene, from, settings);
    CHECK(last == 1);
    settings.progress = [](double) { return false; };
    CHECK_THROWS_AS(trace_truth(scene, from, settings), truth_cancelled);
    settings.progress = [](double) -> bool { throw asked_to_fail(); };
    CHECK_THROWS_AS(trace_truth(scene, from, settings), asked_to_fail);
}

TEST_CASE("truth: settings that mean nothing") {
    const camera from = look({0, 5, 8}, {0, 0, 0});
    const auto expect = [&](const std::string& part, const truth_settings& settings) {
        expect_error<truth_error>(part, [&] { trace_truth(ground(), from, settings); });
    };
    expect("0 x 9 texels; both must be 1 to 16384", {.width = 0, .height = 9});
    expect("9 x 16385 texels", {.width = 9, .height = 16385});
    expect("radius -1", {.radius = -1});
    expect("radius nan", {.radius = std::numeric_limits<float>::quiet_NaN()});
    expect("radius inf", {.radius = std::numeric_limits<float>::infinity()});
    expect("0 rays", {.rays = 0});
    expect_error<scene_error>("has no triangles", [&] { trace_truth({}, from, {}); });
}

namespace {

truth truth_of(const placed_scene& scene) {
    return trace_truth(scene.triangles, scene.from,
                       {.width = scene.from.width,
                        .height = scene.from.height,
                        .radius = scene.from.ao_radius,
                        .rays = 16,
                        .first_layer = true});
}

/// How the visibility of an image differs in the mean.
double mean_difference(const image& a, const image& b) {
    return compare(a, b).mae;
}

}

TEST_CASE("truth: the same wherever the scene is") {
    const truth here = truth_of(placed_scene(1));
    for (const glm::dvec3 place : {glm::dvec3(1e5, 0, -1e5), glm::dvec3(-6.4e6, 6.4e6, 3)}) {
        const truth there = truth_of(placed_scene(1, place));
        CHECK(there.depth.texels == here.depth.texels);
        CHECK(there.normal.texels == here.normal.texels);
        CHECK(there.bent.texels == here.bent.texels);
        CHECK(there.ao_hard.texels == here.ao_hard.texels);
        CHECK(there.ao_linear.texels == here.ao_linear.texels);
        CHECK(there.ao_quad.texels == here.ao_quad.texels);
        CHECK(there.ao_first_layer.texels == here.ao_first_layer.texels);
    }
}

TEST_CASE("truth: the same for a scene of any size") {
    const truth one = truth_of(placed_scene(1));
    for (const double size : {0x1p-80, 0x1p-40, 0x1p50, 0x1p80}) {
        CAPTURE(size);
        const truth other = truth_of(placed_scene(size));
        CHECK(shrunk(other.depth, size).texels == one.depth.texels);
        CHECK(other.normal.texels == one.normal.texels);
        CHECK(other.bent.texels == one.bent.texels);
        CHECK(other.ao_linear.texels == one.ao_linear.texels);
        CHECK(other.ao_first_layer.texels == one.ao_first_layer.texels);
    }
    for (const double size : {1e-12, 1e-6, 1e9, 1e15}) { // which round every position anew
        CAPTURE(size);
        const truth other = truth_of(placed_scene(size));
        const double visibility = mean_difference(other.ao_linear, one.ao_linear),
                     depth = mean_difference(shrunk(other.depth, size), one.depth);
        MESSAGE("size " << size << ": visibility differs by " << visibility << ", depth by " << depth);
        CHECK(visibility <= 5e-7); // measured: 1.4e-7
        CHECK(depth <= 2.5e-6);    // measured: 6.5e-7
    }
}

TEST_CASE("truth: an eye too far away is refused") {
    camera from = look({0, 0, 1.9e18}, {0, 0, 0});
    mesh box;
    add_box(box, {-1, -1, -1}, {1, 1, 1});
    const truth_settings settings{.width = 4, .height = 4, .radius = 1, .rays = 1};
    const auto refused = [&](const std::string& part) {
        expect_error<scene_error>(part, [&] { trace_truth(box, from, settings); });
    };
    refused(
        "the radius 1 is out of what 32-bit positions allow from this eye, which the scene begins 1.9e+18 ");
    from.eye = {1e8, 0, 0};
    from.far = 2e8f;
    refused(
        "the radius 1 is out of what 32-bit positions allow from this eye, which the scene begins 1e+08 ");
    from.eye = {1.9e18, 1.9e18, 1.9e18};
    refused("no triangle has an area; move the camera nearer");
}

TEST_CASE("truth: near and far of any size") {
    placed_scene scene(1);
    const truth expected = truth_of(scene);
    for (const auto& [near, far] : {std::pair{1e-30f, 1e30f}, {1e-7f, 1e7f}, {1e-38f, 3e38f}}) {
        scene.from.near = near;
        scene.from.far = far;
        const truth seen = truth_of(scene);
        CHECK(seen.ao_linear.texels == expected.ao_linear.texels);
        CHECK(*std::ranges::max_element(seen.depth.texels) == far);
    }
    scene.from.near = 1e37f;
    CHECK(all_are(truth_of(scene).ao_linear, 1));
}

TEST_CASE("truth: no corner that rounding folds up makes a number that is none") {
    mesh scene = ground({0, 0, -400});
    for (unsigned i = 0; i < 64; ++i) // 32-bit positions are 3e-5 apart there
        add_rectangle(scene, {-3 + 0.1 * i, 0.5, -400}, {1e-5, 0, 0}, {0, 1e-5, 1e-5});
    const camera from = look({0, 3, 0}, {0, 0, -100});
    const truth seen = trace_truth(scene, from, {.width = 32, .height = 18, .radius = 2, .rays = 16});
    for (const image* pixels : {&seen.depth, &seen.normal, &seen.bent, &seen.ao_linear})
        CHECK(std::ranges::all_of(pixels->texels, [](float texel) { return std::isfinite(texel); }));
}
