// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <complex>
#include <cstdint>
#include <numbers>
#include <vector>

static_assert(crease::recipe("directions/single_layer/hbao/blue_noise"));
static_assert(crease::blue_noise::rank(64, 0) == crease::blue_noise::rank(0, 64)); // it repeats

namespace {

constexpr unsigned side = crease::blue_noise_side;

std::vector<std::uint32_t> texels_of_tile() {
    std::vector<std::uint32_t> texels(side * side);
    crease::blue_noise::fill(texels);
    return texels;
}

/// The three numbers of a texel, each from 0 to 1.
double number_of(std::uint32_t texel, unsigned which) {
    return which == 0   ? (texel >> 21) / 2048.0
           : which == 1 ? (texel >> 10 & 2047) / 2048.0
                        : (texel & 1023) / 1024.0;
}

/// The mean power of a tile's frequencies between two of them, cycles a tile, over that of white noise.
double power_between(const std::vector<double>& tile, double least, double most) {
    const int n = static_cast<int>(side);
    double power = 0, frequencies = 0;
    for (int v = -n / 2; v < n / 2; ++v)
        for (int u = -n / 2; u < n / 2; ++u) {
            const double frequency = std::hypot(u, v);
            if (frequency < least || frequency >= most)
                continue;
            std::complex<double> sum = 0;
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x)
                    sum += (tile[static_cast<std::size_t>(y * n + x)] - 0.5) *
                           std::polar(1.0, -2 * std::numbers::pi * (u * x + v * y) / n);
            power += std::norm(sum) / (n * n);
            ++frequencies;
        }
    return power / frequencies / (1.0 / 12);
}

}

TEST_CASE("blue_noise takes the place of the default and brings its tile, once and for good") {
    using effect =
        crease::effect<crease::directions<>, crease::single_layer, crease::hbao, crease::blue_noise>;
    CHECK(has_part_of(effect::passes[0], "noise/blue_noise.glsl"));
    const auto tile =
        std::ranges::find(effect::resources, std::string_view("blue_noise"), &crease::resource::name);
    REQUIRE(tile != effect::resources.end());
    CHECK(tile->life == crease::lifetime::constant);
    CHECK(tile->size.width_of(1280) == side);
    CHECK(tile->size.height_of(720) == side);
    CHECK((tile->fill == crease::blue_noise::fill));
}

TEST_CASE("the three numbers of the tile take every value equally often") {
    for (unsigned which = 0; which < 3; ++which) {
        const unsigned values = which < 2 ? 2048 : 1024;
        std::vector<unsigned> often(values);
        for (std::uint32_t texel : texels_of_tile())
            ++often.at(static_cast<std::size_t>(number_of(texel, which) * values));
        CHECK(*std::ranges::min_element(often) == side * side / values);
        CHECK(*std::ranges::max_element(often) == side * side / values);
    }
}

TEST_CASE(
    "the tile is blue: it has hardly any low frequencies, and the three numbers are of different places") {
    for (unsigned which = 0; which < 3; ++which) {
        std::vector<double> tile;
        for (std::uint32_t texel : texels_of_tile())
            tile.push_back(number_of(texel, which) + 0.25 / 1024);
        CHECK(power_between(tile, 0.5, 8) < 0.03);
        CHECK(power_between(tile, 24, 64) > 1.2);
    }
    for (unsigned which = 0; which < 3; ++which) {
        double product = 0;
        for (std::uint32_t texel : texels_of_tile())
            product += (number_of(texel, which) - 0.5) * (number_of(texel, (which + 1) % 3) - 0.5) * 12;
        CHECK(std::abs(product / (side * side)) < 0.05);
    }
}
