// SPDX-License-Identifier: MIT
// Texels of linear depth that hold no depth: 0, less, NaN, and at or beyond the far plane. Such a receiver is
// open, and such a tap occludes nothing.
#include "captured.hpp"
#include "techniques.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <memory>

namespace {

using oracle::lens;

constexpr float infinity = std::numeric_limits<float>::infinity();
const float holes[] = {0.0f, -0.0f, -1.0f, -infinity, std::nanf(""), infinity, 50.0f, 1e20f};

/// Makes each third texel or so background, and gives the linear depths of a host that has the hole there.
std::vector<float> punch(oracle::picture& p) {
    std::vector<float> linear;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            const std::size_t i = p.index(x, y);
            const bool hole = (x + 2 * y) % 5 == 0;
            if (hole)
                p.device[i] = static_cast<float>(p.clear_value());
            linear.push_back(hole ? holes[i % std::size(holes)]
                                  : static_cast<float>(p.background(x, y) ? 1e9 : -p.position(x, y).z));
        }
    return linear;
}

}

TEST_CASE("holes in linear depth are background") {
    for (lens kind : {lens::standard, lens::orthographic}) {
        oracle::picture p = oracle::draw(oracle::still_life(), kind, 97, 61);
        const std::vector<float> linear = punch(p);
        for (const oracle::technique& t : oracle::techniques())
            for (const char* stage : {"", "/fragment"}) {
                CAPTURE(t.recipe());
                CAPTURE(std::string(stage));
                const auto composed = oracle::compose(t.recipe() + "/linear_depth" + stage +
                                                      (kind == lens::orthographic ? "/orthographic" : ""));
                const crease::parameters how = oracle::view_parameters(p, *composed, 0.5);
                crease::vulkan::runner runner(oracle::device(), *composed, static_cast<unsigned>(p.width),
                                              static_cast<unsigned>(p.height));
                oracle::upload(runner, *composed, p);
                runner.upload("depth", linear);
                runner.run(how);
                const oracle::settings s = oracle::settings_of(how, *composed);
                const auto expected = oracle::main_pass(
                    p, s, 1, false, [&](const oracle::receiver& r) { return t.occlusion(p, r, s); });
                oracle::check_within(oracle::compare(runner.download("visibility"), expected),
                                     oracle::of_rounding);
            }
    }
}

TEST_CASE("holes among captured layers are no layers") {
    oracle::picture p = oracle::draw_all(oracle::still_life(), lens::standard, 97, 61);
    const oracle::technique& t = oracle::techniques()[1];
    const auto composed =
        oracle::compose(t.sampler + "/stochastic_layers:6/" + t.estimator + "/atomic_minimum");
    const crease::parameters how = oracle::view_parameters(p, *composed, 0.8);
    const given_layers given(*composed);
    crease::vulkan::runner runner(oracle::device(), given, static_cast<unsigned>(p.width),
                                  static_cast<unsigned>(p.height));
    oracle::upload(runner, given, p);
    // Three samples hold the layers of the texel and three are holes.
    std::vector<std::uint32_t> bits;
    for (unsigned s = 0; s < 6; ++s)
        for (int y = 0; y < p.height; ++y)
            for (int x = 0; x < p.width; ++x) {
                const std::vector<glm::dvec3> all = p.positions(x, y);
                const bool hole = s % 2 == 1 || p.background(x, y);
                bits.push_back(std::bit_cast<std::uint32_t>(
                    hole ? holes[(p.index(x, y) + s) % std::size(holes)]
                         : static_cast<float>(-all[std::min<std::size_t>(s / 2, all.size() - 1)].z)));
            }
    for (std::vector<float>& behind : p.hidden)
        behind.resize(std::min<std::size_t>(behind.size(), 2));
    runner.upload("captured_layers", bits);
    runner.run(how);
    const oracle::settings s = oracle::settings_of(how, *composed);
    const auto expected =
        oracle::main_pass(p, s, 1, false, [&](const oracle::receiver& r) { return t.occlusion(p, r, s); });
    oracle::check_within(oracle::compare(runner.download("visibility"), expected), oracle::of_rounding);
}
