// SPDX-License-Identifier: MIT
// The levels of depth_pyramid against those made on the host, and the occlusion over them against the taps of
// the technique, each moved to the texel that its level has.
#include "run.hpp"
#include "slices.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using oracle::lens;

struct level {
    int width, height;
    std::vector<float> texels;
    float at(int x, int y) const {
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

/// Splits what a runner downloads: level after level.
std::vector<level> levels_of(const std::vector<float>& all, int width, int height, int count) {
    std::vector<level> levels;
    auto from = all.begin();
    for (int i = 0; i < count; ++i) {
        level own{std::max(width >> i, 1), std::max(height >> i, 1), {}};
        own.texels.assign(from, from + own.width * own.height);
        from += own.width * own.height;
        levels.push_back(own);
    }
    CHECK(from == all.end());
    return levels;
}

/// The texels of the first level for which one of another stands: those whose halves, halved again, end
/// there; at an odd edge with what is left over.
float nearest_of(const level& first, const level& of, int i, int x, int y) {
    const auto end = [i](int at, int size, int whole) { return at + 1 == size ? whole : (at + 1) << i; };
    float nearest = INFINITY;
    for (int v = y << i; v < end(y, of.height, first.height); ++v)
        for (int u = x << i; u < end(x, of.width, first.width); ++u)
            nearest = std::min(nearest, first.at(u, v));
    return nearest;
}

void check_levels(int width, int height, int nearest, int expected) {
    CAPTURE(width);
    CAPTURE(height);
    CAPTURE(nearest);
    oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, width, height);
    std::shuffle(p.device.begin(), p.device.end(),
                 std::mt19937(1)); // so that what is left over is the nearest somewhere
    oracle::prepared& ready =
        oracle::prepare(fmt::format("directions:8x4/depth_pyramid:12x{}/hbao", nearest), p);
    oracle::upload(ready.runner, ready.composed, p);
    ready.runner.run(oracle::view_parameters(p, ready.composed, 0.8));
    const std::vector<level> levels =
        levels_of(ready.runner.download("depth_pyramid"), width, height, expected);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double depth = p.background(x, y) ? 1e15 : -p.position(x, y).z;
            REQUIRE(levels[0].at(x, y) == doctest::Approx(depth).epsilon(1e-4));
        }
    for (int i = 1; i < expected; ++i) {
        const level& own = levels[static_cast<std::size_t>(i)];
        for (int y = 0; y < own.height; ++y)
            for (int x = 0; x < own.width; ++x) {
                CAPTURE(i);
                REQUIRE(own.at(x, y) ==
                        (nearest ? nearest_of(levels[0], own, i, x, y) : levels[0].at(x << i, y << i)));
            }
    }
}

/// The tap where a level of the spacing that it has between its neighbours puts it.
oracle::tap moved(const oracle::picture& p, const oracle::receiver& r, oracle::tap t, double spacing,
                  int levels) {
    const double way = std::max(std::abs(t.x - r.x), std::abs(t.y - r.y));
    const int i = std::clamp(
        static_cast<int>(std::floor(std::log2(std::max(std::floor(std::min(spacing, 2 * way)) / 4, 1.0)))), 0,
        levels - 1);
    const auto snap = [i](int at, int size) {
        return std::min((at + (1 << i) / 2) >> i, std::max(size >> i, 1) - 1) << i;
    };
    t.x = snap(t.x, p.width);
    t.y = snap(t.y, p.height);
    t.point = p.position(t.x, t.y);
    return t;
}

}

TEST_CASE("each level holds of four texels of the one before the first or the nearest, at odd edges too") {
    for (int nearest : {0, 1}) {
        check_levels(97, 61, nearest, 7);
        check_levels(64, 32, nearest, 7);
        check_levels(33, 1, nearest, 6);
        check_levels(1, 1, nearest, 1);
    }
}

TEST_CASE("where taps are next to each other the pyramid gives what single_layer gives, to the bit") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::reversed, 97, 61);
    for (const std::string rest : {"hbao", "hbao_plus", "hbao/bent_cone"})
        for (int nearest : {0, 1}) {
            CAPTURE(rest);
            const std::vector<float> one = oracle::run(p, "directions:8x4/single_layer/" + rest, 0.06);
            CHECK(oracle::run(p, fmt::format("directions:8x4/depth_pyramid:6x{}/{}", nearest, rest), 0.06) ==
                  one);
            CHECK(*std::ranges::min_element(one) < 0.9f);
        }
}

TEST_CASE("the taps are those of the technique, moved to texels of the level of their spacing") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 193, 121);
    constexpr int count = 7, steps = 3, levels = 6;
    for (const std::string& sampler :
         {fmt::format("poisson_disk:{}", count), fmt::format("directions:6x{}", steps)}) {
        CAPTURE(sampler);
        const bool on_disk = sampler.starts_with("poisson");
        const auto composed = oracle::compose(fmt::format("{}/depth_pyramid:{}/hbao_plus", sampler, levels));
        const crease::parameters how = oracle::view_parameters(p, composed->view(), 1.6);
        const oracle::settings s = oracle::settings_of(how, composed->view());
        std::size_t coarse = 0;
        const auto occlusion = [&](const oracle::receiver& r) {
            glm::dvec3 across, up;
            oracle::axes(p, r, across, up);
            const glm::dvec2 a = oracle::texel_offset(p, r, s.radius * across),
                             b = oracle::texel_offset(p, r, s.radius * up);
            // The area of the radius' disk in texels, shared out among the taps; or how far a step goes.
            const double of_disk = std::sqrt(3.14159265 * std::abs(a.x * b.y - a.y * b.x) / count);
            std::vector<std::vector<oracle::tap>> taps =
                on_disk ? oracle::poisson_disk(p, r, s, count) : oracle::directions(p, r, s, 6, steps);
            for (std::vector<oracle::tap>& each : taps)
                for (oracle::tap& t : each) {
                    const double of_step =
                        glm::length(oracle::texel_offset(p, r, s.radius * t.azimuth)) * 2 * t.weight / steps;
                    const oracle::tap own = moved(p, r, t, on_disk ? of_disk : of_step, levels);
                    coarse += own.x != t.x || own.y != t.y;
                    t = own;
                }
            return oracle::hbao_plus(p, r, s, taps);
        };
        const oracle::visibility_image expected = oracle::main_pass(p, s, 1, false, occlusion);
        CHECK(coarse > 1000);
        oracle::check_within(oracle::compare(oracle::run(p, composed->view(), how), expected),
                             oracle::of_rounding);
    }
}

TEST_CASE("half directions over the pyramid look at the level of the spacing of their steps") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 193, 121);
    constexpr int count = 3, steps = 5, levels = 6;
    const auto composed = oracle::compose(
        fmt::format("half_directions:{}x{}/depth_pyramid:{}/cosine_bitmask:0x1", count, steps, levels));
    const crease::parameters how = oracle::view_parameters(p, composed->view(), 1.6);
    const oracle::settings s = oracle::settings_of(how, composed->view());
    std::size_t coarse = 0;
    const auto occlusion = [&](const oracle::receiver& r) {
        oracle::half_slices where = oracle::half_directions(p, r, s, count, steps, 2);
        for (oracle::half_slice& each : where.all) {
            const double texels = glm::length(oracle::texel_offset(p, r, s.radius * each.azimuth));
            for (oracle::march_tap& t : each.taps) {
                const double spacing = texels * 2 * std::sqrt(t.distance) / steps;
                const oracle::tap own = moved(p, r, oracle::tap{t.x, t.y, {}}, spacing, levels);
                coarse += own.x != t.x || own.y != t.y;
                t.x = own.x;
                t.y = own.y;
            }
        }
        return oracle::cosine_bitmask(p, r, s, where, false, true);
    };
    const oracle::visibility_image expected = oracle::main_pass(p, s, 1, false, occlusion);
    CHECK(coarse > 1000);
    oracle::check_within(oracle::compare(oracle::run(p, composed->view(), how), expected),
                         oracle::of_rounding);
}

TEST_CASE("a plane is unoccluded at every slant, however coarse the levels are") {
    const oracle::picture p =
        oracle::draw({{oracle::surface::kind::plane, {0, -1, -3}, glm::normalize(glm::dvec3(0.3, 1, 0.2))}},
                     lens::standard, 161, 97);
    for (float visibility : oracle::run(p, "directions:6x3/depth_pyramid/hbao", 30))
        CHECK(visibility > 0.999f);
}
