// SPDX-License-Identifier: MIT
#include "measure/compare.hpp"

#include "expect_error.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

using namespace crease::tools;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN(),
                infinite = std::numeric_limits<float>::infinity();

image row(std::initializer_list<float> values) {
    image pixels(static_cast<unsigned>(values.size()), 1);
    pixels.texels = values;
    return pixels;
}

/// Values in [0, 1) without a pattern; 40 x 30.
image noise(unsigned channels, std::uint64_t seed) {
    image pixels(40, 30, channels);
    for (std::uint64_t i = 0; i < pixels.texels.size(); ++i)
        pixels.texels[i] = static_cast<float>(((i + seed) * (i + seed) * 7919 + i * 31) % 1009) / 1009.0f;
    return pixels;
}

/// `reference`, a quarter of it replaced by other noise, one texel broken.
image disturbed(const image& reference) {
    image test = noise(reference.channels, 5);
    for (std::size_t i = 0; i < test.texels.size(); ++i)
        test.texels[i] = 0.75f * reference.texels[i] + 0.25f * test.texels[i];
    test.texels[std::size_t{100} * test.channels] = not_a_number;
    return test;
}

/// Background on the left and, a bit deeper, in the upper right corner.
image some_depth() {
    image depth(40, 30, 1, 2);
    for (unsigned y = 0; y < 30; ++y)
        for (unsigned x = 0; x < 40; ++x)
            if (x < 3)
                depth.at(x, y) = 100;
            else if (x >= 30 && y < 4)
                depth.at(x, y) = 101;
    return depth;
}

}

TEST_CASE("compare: by hand") {
    const comparison c = compare(row({0, 0.5f, 1, 0.25f}), row({0, 0, 0.5f, 0.5f}));
    CHECK(c.pixels == 4);
    CHECK(c.background == 0);
    CHECK(c.nonfinite == 0);
    CHECK(c.rmse == 0.375); // differences 0, 1/2, 1/2, -1/4: mean square 9/64
    CHECK(c.mae == 0.3125);
    CHECK(c.bias == 0.1875);
    CHECK(std::abs(c.psnr_db - 20 * std::log10(1 / 0.375)) <= 1e-14);
    CHECK(c.p99_abs == 0.5);
    CHECK(c.max_abs == 0.5);
    CHECK(std::isnan(c.ssim)); // no 8 x 8 window
}

TEST_CASE("compare: the percentile lies between its two ranks") {
    const comparison c = compare(row({0, 1}), row({0, 0}));
    CHECK(std::abs(c.p99_abs - 0.99) <= 1e-15);
}

TEST_CASE("compare: an image with itself") {
    const image pixels = noise(1, 1);
    const comparison c = compare(pixels, pixels);
    CHECK(c.rmse == 0);
    CHECK(c.psnr_db == std::numeric_limits<double>::infinity());
    CHECK(std::abs(c.ssim - 1) <= 1e-14);
}

TEST_CASE("compare: structural similarity of two constants") {
    // Without variance it is (2ab + c1) / (a^2 + b^2 + c1), c1 = 1e-4.
    const comparison c = compare(image(9, 8, 1, 0.5f), image(9, 8, 1, 0.25f));
    CHECK(std::abs(c.ssim - (0.25 + 1e-4) / (0.3125 + 1e-4)) <= 1e-14);
}

TEST_CASE("compare: broken texels and background are left out, and shown in the difference") {
    const image depth = row({1, 1, 1, 9, 9, not_a_number});
    image difference;
    const comparison c =
        compare(row({1, not_a_number, 0.5f, 7, not_a_number, 0}), row({0.75f, 0, infinite, 0, 0, 0}),
                {.depth = &depth, .far = 9.0f, .difference = &difference});
    CHECK(c.pixels == 1);
    CHECK(c.nonfinite == 2);
    CHECK(c.background == 3);
    CHECK(c.rmse == 0.25);
    CHECK(difference.texels == std::vector<float>{0.25f, infinite, infinite, 0, 0, 0});
    // Without a far, the largest depth is background.
    const image deepest_last = row({1, 2, 7});
    CHECK(compare(row({1, 1, 1}), row({1, 1, 1}), {.depth = &deepest_last}).background == 1);
}

TEST_CASE("compare: the numbers of an independent program in NumPy") {
    const image depth = some_depth();
    struct {
        unsigned channels;
        comparison_settings settings;
        comparison expected;
    } const cases[] = {
        {1,
         {.depth = &depth, .far = 100.0f},
         {1069, 130, 1, 0.10268278729301789, 0.0838797865056505, 0.0002568090683889512, 19.770047020980417,
          0.9209765680500934, 0.2247571803629396, 0.24405351281166077}},
        {3,
         {.depth = &depth, .far = 100.0f},
         {1069, 130, 1, 0.10188599646477922, 0.08319751093037615, -0.00010468674260114662, 19.83771005411987,
          0.9173476736219457, 0.22348860278725624, 0.24405351281166077}},
        {1,
         {.depth = &depth, .peak = 2},
         {1159, 40, 1, 0.1022508654904892, 0.08351839430902613, -0.00010902788092296272, 25.827260058684153,
          0.9229557147347357, 0.2232011625915766, 0.24405351281166077}},
    };
    for (const auto& [channels, settings, expected] : cases) {
        const image reference = noise(channels, 1);
        const comparison c = compare(disturbed(reference), reference, settings);
        const auto close = [](double found, double right) {
            return std::abs(found - right) <= 1e-13 * right;
        };
        CHECK(c.pixels == expected.pixels);
        CHECK(c.background == expected.background);
        CHECK(c.nonfinite == expected.nonfinite);
        CHECK(close(c.rmse, expected.rmse));
        CHECK(close(c.mae, expected.mae));
        CHECK(std::abs(c.bias - expected.bias) <= 1e-15);
        CHECK(close(c.psnr_db, expected.psnr_db));
        CHECK(close(c.ssim, expected.ssim));
        CHECK(close(c.p99_abs, expected.p99_abs));
        CHECK(c.max_abs == expected.max_abs);
    }
}

TEST_CASE("compare: images that do not belong together") {
    const image depth(2, 1, 3), all_far(2, 1, 1, 5);
    expect_error<comparison_error>("the test is 2 x 1 x 1 channels, the reference 3 x 1 x 1", [] {
        compare(row({0, 0}), row({0, 0, 0}));
    });
    expect_error<comparison_error>("sizes differ", [] { compare(image(2, 1, 3), image(2, 1, 1)); });
    expect_error<comparison_error>("the depth is 2 x 1 x 3 channels; the reference needs 2 x 1 x 1", [&] {
        compare(row({0, 0}), row({0, 0}), {.depth = &depth});
    });
    expect_error<comparison_error>("of 2, 2 are background and 0 not finite", [&] {
        compare(row({0, 0}), row({0, 0}), {.depth = &all_far});
    });
    expect_error<comparison_error>("no pixels to compare", [] { compare(image(), image()); });
}
