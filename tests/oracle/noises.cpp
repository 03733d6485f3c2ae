// SPDX-License-Identifier: MIT
// The numbers of each noise, as the shader has them: the oracle's, and how they are spread.
#include "run.hpp"

#include <doctest/doctest.h>

#include <array>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

constexpr crease::glsl_file shown_noise_glsl{"test/shown_noise.glsl", R"glsl(
crease_result crease_evaluate(ivec2 pixel) {
    crease_result result = crease_open_result();
    vec3 noise = crease_noise(pixel);
    result.visibility = crease_shown_noise_which == 0 ? noise.x : crease_shown_noise_which == 1 ? noise.y : noise.z;
    return result;
}
)glsl"};

struct shown_noise {
    static constexpr crease::number takes[] = {{"which", 0, 2, 0, "of the three numbers"}};
    static constexpr const crease::glsl_file* files[] = {&shown_noise_glsl};
    static constexpr crease::part description{.kind = crease::role::receivers,
                                              .name = "shown_noise",
                                              .summary = "",
                                              .source = "",
                                              .files = files,
                                              .numbers = takes};
};

constexpr int width = 192, height = 128;

/// One of the three numbers, of every pixel.
std::vector<float> numbers_of(const std::string& noise, int which, std::uint32_t frame = 0) {
    static constexpr auto known = [] {
        std::array<const crease::part*, std::size(crease::all_parts) + 1> all{&shown_noise::description};
        std::copy(std::begin(crease::all_parts), std::end(crease::all_parts), all.begin() + 1);
        return all;
    }();
    const crease::recipe chosen(
        "directions/single_layer/hbao/r32f/shown_noise:" + std::to_string(which) + "/" + noise, known);
    REQUIRE_MESSAGE(static_cast<bool>(chosen), chosen.error());
    const auto composed = std::make_unique<crease::composition>(chosen);
    static const oracle::picture p = oracle::draw({{oracle::surface::kind::plane, {0, 0, -2}, {0, 0, 1}}},
                                                  oracle::lens::standard, width, height);
    crease::parameters how = oracle::view_parameters(p, *composed, 1);
    how.frame = frame;
    return oracle::run(p, *composed, how);
}

constexpr const char* noises[] = {"hashed_noise", "tiled_noise:16", "interleaved_gradient_noise",
                                  "hilbert_r2_noise", "blue_noise"};

/// The numbers without those that are the same again: some noises repeat after 64 x 64 pixels.
std::vector<double> distinct(const std::string& noise, const std::vector<float>& numbers) {
    const bool repeats = noise != "hashed_noise" && noise != "interleaved_gradient_noise";
    std::vector<double> all;
    for (int y = 0; y < (repeats ? 64 : height); ++y)
        for (int x = 0; x < (repeats ? 64 : width); ++x)
            all.push_back(double{numbers[static_cast<std::size_t>(y * width + x)]});
    return all;
}

/// Chi-squared of numbers in equal bins, per degree of freedom: 1 for what is drawn at random.
double chi_squared(const std::vector<double>& numbers, std::size_t bins) {
    std::vector<double> counts(bins);
    for (double n : numbers)
        counts.at(static_cast<std::size_t>(n * static_cast<double>(bins)))++;
    const double expected = static_cast<double>(numbers.size()) / static_cast<double>(bins);
    double sum = 0;
    for (double c : counts)
        sum += (c - expected) * (c - expected) / expected;
    return sum / static_cast<double>(bins - 1);
}

/// The variance of the means over all squares of some pixels a side, in that of numbers drawn at random.
double variance_of_means(const std::vector<float>& numbers, int side) {
    double squares = 0;
    int count = 0;
    for (int y = 0; y + side <= height; ++y)
        for (int x = 0; x + side <= width; ++x, ++count) {
            double mean = 0;
            for (int j = 0; j < side; ++j)
                for (int i = 0; i < side; ++i)
                    mean += numbers[static_cast<std::size_t>((y + j) * width + x + i)] / double(side * side);
            squares += (mean - 0.5) * (mean - 0.5);
        }
    return squares / count * 12 * side * side;
}

}

TEST_CASE("each noise is the oracle's, in each of its numbers and in every frame") {
    for (const char* noise : noises)
        for (int which = 0; which < 3; ++which)
            for (std::uint32_t frame : {0u, 1u, 70u}) {
                CAPTURE(std::string(noise));
                CAPTURE(which);
                CAPTURE(frame);
                const std::vector<float> numbers = numbers_of(noise, which, frame);
                oracle::settings s;
                s.noise = noise;
                s.frame = frame;
                int apart = 0;
                for (int y = 0; y < height; ++y)
                    for (int x = 0; x < width; ++x) {
                        const double d = std::abs(numbers[static_cast<std::size_t>(y * width + x)] -
                                                  oracle::noise(x, y, s)[which]);
                        apart += std::min(d, 1 - d) > 1e-3; // 0 and 1 are neighbours
                    }
                CHECK(apart == 0);
            }
}

TEST_CASE("the numbers of each noise lie in [0, 1), and fill it evenly") {
    for (const char* noise : noises)
        for (int which = 0; which < 3; ++which)
            for (std::uint32_t frame : {0u, 5u}) {
                CAPTURE(std::string(noise));
                CAPTURE(which);
                CAPTURE(frame);
                const std::vector<float> numbers = numbers_of(noise, which, frame);
                for (float n : numbers)
                    REQUIRE((n >= 0 && n < 1));
                // Of 15 degrees of freedom 1 in 20 of what is random exceeds this; tiles of 16 hold 256
                // numbers.
                CHECK(chi_squared(distinct(noise, numbers), 16) <
                      (std::string(noise) == "tiled_noise:16" ? 16 : 1) * 1.67);
            }
}

TEST_CASE("any two of the three numbers fill the square evenly") {
    for (const char* noise : {"hashed_noise", "interleaved_gradient_noise", "hilbert_r2_noise", "blue_noise"})
        for (int which = 0; which < 3; ++which) {
            CAPTURE(std::string(noise));
            CAPTURE(which);
            const std::vector<double> a = distinct(noise, numbers_of(noise, which)),
                                      b = distinct(noise, numbers_of(noise, (which + 1) % 3));
            std::vector<double> cells;
            for (std::size_t i = 0; i < a.size(); ++i)
                cells.push_back((std::floor(a[i] * 8) + b[i]) / 8); // 8 strips, by 8
            CHECK(chi_squared(cells, 64) < 1.4);                    // of 63 degrees of freedom, 1 in 40
        }
}

TEST_CASE("pixels near each other divide the numbers evenly, so a blur leaves less than of random ones") {
    struct expectation {
        const char* noise;
        double most[3]; ///< over squares of 3, 5 and 8 pixels a side
    };
    for (const expectation& each : {expectation{"interleaved_gradient_noise", {0.2, 0.2, 0.1}},
                                    {"hilbert_r2_noise", {0.7, 0.65, 0.5}},
                                    {"blue_noise", {0.4, 0.3, 0.2}}})
        for (int which = 0; which < 3; ++which)
            for (std::uint32_t frame : {0u, 3u}) {
                CAPTURE(std::string(each.noise));
                CAPTURE(which);
                CAPTURE(frame);
                const std::vector<float> numbers = numbers_of(each.noise, which, frame);
                const int sides[] = {3, 5, 8};
                for (std::size_t i = 0; i < 3; ++i) {
                    CAPTURE(sides[i]);
                    CHECK(variance_of_means(numbers, sides[i]) < each.most[i]);
                }
            }
    CHECK(variance_of_means(numbers_of("hashed_noise", 0), 5) > 0.9);
}

TEST_CASE("a pixel's numbers of a few frames divide [0, 1) evenly") {
    for (const char* noise : {"interleaved_gradient_noise", "hilbert_r2_noise", "blue_noise"})
        for (int which = 0; which < 3; ++which) {
            CAPTURE(std::string(noise));
            CAPTURE(which);
            std::vector<std::vector<float>> frames;
            for (std::uint32_t frame = 0; frame < 8; ++frame)
                frames.push_back(numbers_of(noise, which, frame));
            double squares = 0;
            for (std::size_t i = 0; i < frames[0].size(); ++i) {
                double mean = 0;
                for (const std::vector<float>& each : frames)
                    mean += double{each[i]} / 8;
                squares += (mean - 0.5) * (mean - 0.5);
            }
            // Of numbers drawn at random it is 1.
            CHECK(squares / static_cast<double>(frames[0].size()) * 12 * 8 < 0.5);
        }
}
