// SPDX-License-Identifier: MIT
// Thresholds other than the defaults, against the oracle. That of the unsharp mask is tested with its
// listing.
#include "areas.hpp"
#include "run.hpp"

#include <doctest/doctest.h>

#include <memory>

namespace {

const oracle::picture& still_life() {
    static const oracle::picture p = oracle::draw(oracle::still_life(), oracle::lens::standard, 97, 61);
    return p;
}

/// Pixels that two pictures have otherwise.
std::size_t others(const std::vector<float>& a, const std::vector<float>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += a[i] != b[i];
    return count;
}

}

TEST_CASE("a threshold leaves taps out that hardly rise over the tangent plane of HBAO") {
    const oracle::picture& p = still_life();
    const auto composed = oracle::compose("directions:6x3/single_layer/hbao");
    crease::parameters how = oracle::view_parameters(p, *composed, 0.5);
    const std::vector<float> without = oracle::run(p, *composed, how);
    for (float threshold : {0.3f, 0.6f}) {
        CAPTURE(threshold);
        oracle::set(how, *composed, "threshold", threshold);
        const oracle::settings s = oracle::settings_of(how, *composed);
        const auto expected = oracle::main_pass(p, s, 1, false, [&](const oracle::receiver& r) {
            return oracle::hbao(p, r, s, oracle::directions(p, r, s, 6, 3));
        });
        const std::vector<float> image = oracle::run(p, *composed, how);
        oracle::check_within(oracle::compare(image, expected), oracle::of_rounding);
        CHECK(others(image, without) > image.size() / 50);
    }
}

TEST_CASE("the threshold of the mean height is how high its box is, and where its falloff begins") {
    const oracle::picture& p = still_life();
    const auto composed = oracle::compose("sample_box/summed_area/mean_height");
    const oracle::area_texels t = oracle::downsample(p, 1);
    crease::parameters how = oracle::view_parameters(p, *composed, 0.5);
    const std::vector<float> of_default = oracle::run(p, *composed, how);
    for (float threshold : {0.05f, 0.6f})
        for (float bias : {0.0f, 0.02f}) {
            CAPTURE(threshold);
            CAPTURE(bias);
            oracle::set(how, *composed, "threshold", threshold);
            oracle::set(how, *composed, "bias", bias);
            const oracle::settings s = oracle::settings_of(how, *composed);
            const auto expected = oracle::main_pass(p, s, 1, false, [&](const oracle::receiver& r) {
                const auto area = oracle::sample_area(p, {r.x + 0.5, r.y + 0.5}, r.position, s.radius);
                return oracle::mean_height(r, s, oracle::sums_over(p, t, oracle::one_layer(p), 1, area),
                                           true);
            });
            const std::vector<float> image = oracle::run(p, *composed, how);
            oracle::check_within(oracle::compare(image, expected), oracle::of_rounding);
            CHECK(others(image, of_default) > image.size() / 50);
        }
}
