// SPDX-License-Identifier: MIT
// Further cameras that see less than the first: a part of it, nothing, or what is behind. The oracle is the
// greater of two occlusions, each from the layers of its own camera. Orthographic cameras a whole number of
// texels apart let it take both at whole texels.
#include "captured.hpp"

#include <doctest/doctest.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <memory>

namespace {

using oracle::lens;

constexpr int width = 100, height = 64;
constexpr unsigned samples = 4;

/// A camera that stands elsewhere: the turn from the first camera's space, and the surfaces in its own.
struct second_camera {
    const char* name;
    glm::dmat4 from_first;
    std::size_t least_darker; ///< pixels
};

std::vector<oracle::surface> turned(std::vector<oracle::surface> scene, const glm::dmat4& turn) {
    for (oracle::surface& s : scene) {
        s.point = glm::dvec3(turn * glm::dvec4(s.point, 1));
        s.normal = glm::dmat3(turn) * s.normal;
    }
    return scene;
}

const std::string recipe = "directions:6x4/stochastic_layers:4/hbao_plus/atomic_minimum/orthographic";

}

TEST_CASE("a second camera adds what it sees alone, be it a part, nothing or what is behind it") {
    const oracle::picture first = oracle::draw(oracle::balls(), lens::orthographic, width, height);
    const double texel = 4.0 / height; // the lens is 4 units high
    const auto moved = [](double x, double y, double z) {
        return glm::translate(glm::dmat4(1), glm::dvec3(x, y, z));
    };
    const second_camera cameras[] = {
        {"in the same place", moved(0, 0, 0), 0},
        {"beside", moved(41 * texel, -17 * texel, 0), 20},
        {"far away", moved(1000 * texel, 0, 0), 0},
        {"in the middle of the scene", moved(0, 0, 3.5), 0},
        {"opposite", glm::rotate(moved(0, 0, -7.9), glm::radians(180.0), glm::dvec3(0, 1, 0)), 30},
        {"beyond it", moved(0, 0, 20), 0}};
    for (const second_camera& camera : cameras) {
        CAPTURE(std::string(camera.name));
        const oracle::picture second =
            oracle::draw(turned(oracle::balls(), camera.from_first), lens::orthographic, width, height);
        const auto composed = oracle::compose(recipe + "/second_view:1");
        crease::parameters how = oracle::view_parameters(first, *composed, 1.5);
        how.further_views[0].view = how.view;
        const glm::mat4 turn(camera.from_first);
        std::copy_n(glm::value_ptr(turn), 16, how.further_views[0].from_first);
        const given_layers given(*composed);
        crease::vulkan::runner runner(oracle::device(), given, width, height);
        oracle::upload(runner, given, first);
        runner.upload("captured_layers", oracle::share_out(first, samples));
        runner.upload("captured_layers_1", oracle::share_out(second, samples));
        runner.run(how);

        const oracle::settings s = oracle::settings_of(how, *composed);
        std::size_t by_second = 0;
        const auto expected = oracle::main_pass(first, s, 1, false, [&](const oracle::receiver& r) {
            const double own = oracle::hbao_plus(first, r, s, oracle::directions(first, r, s, 6, 4));
            oracle::receiver other = r;
            other.position = glm::dvec3(camera.from_first * glm::dvec4(r.position, 1));
            if (!(other.position.z < 0))
                return own;
            other.normal = glm::dmat3(camera.from_first) * r.normal;
            const glm::dvec2 place = second.project(other.position);
            other.x = static_cast<int>(std::floor(place.x));
            other.y = static_cast<int>(std::floor(place.y));
            const double seen =
                oracle::hbao_plus(second, other, s, oracle::directions(second, other, s, 6, 4));
            by_second += seen > own + 0.01;
            return std::max(own, seen);
        });
        CHECK(by_second >= camera.least_darker);
        oracle::check_within(oracle::compare(runner.download("visibility"), expected), oracle::of_rounding);
    }
}

TEST_CASE("a second camera that sees nothing leaves the picture of the first") {
    const oracle::picture first = oracle::draw_all(oracle::still_life(), lens::standard, width, height);
    const std::string one = "directions:6x4/stochastic_layers:4/hbao_plus/atomic_minimum";
    const auto run = [&](const std::string& text, const glm::mat4& turn) {
        const auto composed = oracle::compose(text);
        crease::parameters how = oracle::view_parameters(first, *composed, 1.5);
        how.further_views[0].view = how.view;
        std::copy_n(glm::value_ptr(turn), 16, how.further_views[0].from_first);
        const given_layers given(*composed);
        crease::vulkan::runner runner(oracle::device(), given, width, height);
        oracle::upload(runner, given, first);
        runner.upload("captured_layers", oracle::share_out(first, samples));
        if (text != one)
            runner.upload(
                "captured_layers_1",
                std::vector<std::uint32_t>(std::size_t{width} * height * samples, oracle::kept_nothing));
        runner.run(how);
        return runner.download("visibility");
    };
    const std::vector<float> single = run(one, glm::mat4(1));
    const glm::vec3 up(0, 1, 0);
    for (const glm::mat4& turn : {glm::mat4(1), glm::rotate(glm::mat4(1), glm::radians(180.0f), up),
                                  glm::translate(glm::mat4(1), glm::vec3(0, 0, 100)),
                                  glm::rotate(glm::mat4(1), glm::radians(90.0f), up)})
        CHECK(run(one + "/second_view:1", turn) == single);
}

TEST_CASE("two further cameras each add what they see alone") {
    const oracle::picture first = oracle::draw(oracle::balls(), lens::orthographic, width, height);
    const double texel = 4.0 / height;
    const glm::dmat4 turns[] = {glm::translate(glm::dmat4(1), glm::dvec3(41 * texel, -17 * texel, 0)),
                                glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -7.9)),
                                            glm::radians(180.0), glm::dvec3(0, 1, 0))};
    const auto composed = oracle::compose(recipe + "/further_views:2x1");
    crease::parameters how = oracle::view_parameters(first, *composed, 1.5);
    const given_layers given(*composed);
    crease::vulkan::runner runner(oracle::device(), given, width, height);
    oracle::upload(runner, given, first);
    runner.upload("captured_layers", oracle::share_out(first, samples));
    std::vector<oracle::picture> others;
    for (std::size_t i = 0; i < 2; ++i) {
        others.push_back(oracle::draw(turned(oracle::balls(), turns[i]), lens::orthographic, width, height));
        how.further_views[i].view = how.view;
        const glm::mat4 turn(turns[i]);
        std::copy_n(glm::value_ptr(turn), 16, how.further_views[i].from_first);
        runner.upload(i == 0 ? "captured_layers_1" : "captured_layers_2",
                      oracle::share_out(others.back(), samples));
    }
    runner.run(how);

    const oracle::settings s = oracle::settings_of(how, *composed);
    std::size_t by[3] = {};
    const auto expected = oracle::main_pass(first, s, 1, false, [&](const oracle::receiver& r) {
        double most = oracle::hbao_plus(first, r, s, oracle::directions(first, r, s, 6, 4));
        std::size_t which = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            oracle::receiver other = r;
            other.position = glm::dvec3(turns[i] * glm::dvec4(r.position, 1));
            if (!(other.position.z < 0))
                continue;
            other.normal = glm::dmat3(turns[i]) * r.normal;
            const glm::dvec2 place = others[i].project(other.position);
            other.x = static_cast<int>(std::floor(place.x));
            other.y = static_cast<int>(std::floor(place.y));
            const double seen =
                oracle::hbao_plus(others[i], other, s, oracle::directions(others[i], other, s, 6, 4));
            which = seen > most + 0.01 ? i + 1 : which;
            most = std::max(most, seen);
        }
        ++by[which];
        return most;
    });
    CHECK(by[1] >= 10);
    CHECK(by[2] >= 10);
    oracle::check_within(oracle::compare(runner.download("visibility"), expected), oracle::of_rounding);
}
