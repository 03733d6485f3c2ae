// SPDX-License-Identifier: MIT
// Which samples keep a fragment, as the coverages of stochastic-depth-ao 5.1 and 8.2 promise: how many, how
// much that varies, and that nothing else can be told from a neighbour, a sample, a layer or a frame. Bounds
// are five standard deviations of what independent coins would give.
#include "captured.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using oracle::layer_capture;
using oracle::lens;
using oracle::triangles;

constexpr unsigned side = 160;

/// Whether each sample of each texel keeps the front layer: sample after sample, row after row.
struct mask {
    unsigned samples;
    std::vector<double> kept; ///< 0 or 1

    std::size_t texels() const { return kept.size() / samples; }
};

mask coverage_of(layer_capture& capture, unsigned samples, const triangles& scene,
                 const oracle::capture_settings& how) {
    capture.draw(scene, how);
    mask found{samples, {}};
    for (std::uint32_t bits : capture.runner().download_uint("captured_layers"))
        found.kept.push_back(bits == oracle::kept_nothing ? 0 : 1);
    return found;
}

double mean(const std::vector<double>& of) {
    double sum = 0;
    for (double v : of)
        sum += v;
    return sum / static_cast<double>(of.size());
}

/// Pearson's correlation of pairs.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const double mean_a = mean(a), mean_b = mean(b);
    double both = 0, own = 0, other = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both += (a[i] - mean_a) * (b[i] - mean_b);
        own += (a[i] - mean_a) * (a[i] - mean_a);
        other += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return both / std::sqrt(own * other);
}

/// Of the number of samples of a texel that keep the layer.
double variance_of_count(const mask& m) {
    std::vector<double> counts(m.texels());
    for (std::size_t i = 0; i < m.kept.size(); ++i)
        counts[i % m.texels()] += m.kept[i];
    const double middle = mean(counts);
    double sum = 0;
    for (double n : counts)
        sum += (n - middle) * (n - middle);
    return sum / static_cast<double>(counts.size());
}

/// Of each sample with itself so many texels away.
double correlation_of_texels(const mask& m, unsigned dx, unsigned dy) {
    std::vector<double> here, there;
    for (std::size_t i = 0; i < m.kept.size(); ++i) {
        const std::size_t x = i % m.texels() % side, y = i % m.texels() / side;
        if (x + dx < side && y + dy < side) {
            here.push_back(m.kept[i]);
            there.push_back(m.kept[i + dy * side + dx]);
        }
    }
    return correlation(here, there);
}

/// Of each sample of a texel with the one so many after it.
double correlation_of_samples(const mask& m, unsigned apart) {
    const auto shift = static_cast<std::ptrdiff_t>(m.texels() * apart);
    return correlation({m.kept.begin(), m.kept.end() - shift}, {m.kept.begin() + shift, m.kept.end()});
}

struct method {
    std::string name;
    bool strata;  ///< the number of samples that keep a fragment is as even as it can be
    double cells; ///< texels that share a number, in the mean
};

// The sine hashes have some 2,000 values in single precision, and so the picture of 25,600 texels as many
// coins.

const method methods[] = {{"stratified", true, 1},
                          {"simple_hash", false, 1},
                          {"hash_4d", false, 12},
                          {"isotropic_threshold", false, 12},
                          {"anisotropic_threshold", false, 12}};

/// Five standard deviations of the mean or the correlation of so many independent numbers in [0, 1].
double doubt(const mask& m, const method& of, double spread = 1) {
    return 5 * spread / std::sqrt(static_cast<double>(m.kept.size()) / of.cells);
}

/// The same of the variance of a number of coins, as a share of it.
double doubt_of_variance(const mask& m, const method& of, double alpha) {
    const double coin = alpha * (1 - alpha), kurtosis = 3 + (1 - 6 * coin) / (m.samples * coin);
    const double coins = static_cast<double>(m.texels()) / of.cells;
    return 5 * std::sqrt((kurtosis - 1) / coins) + 25 / coins; // and the square of the mean's
}

/// The floor below the eye, that a texel's ray meets at a grazing angle.
triangles floor_below() {
    triangles all;
    oracle::add_quad(all, {-400, -1, 0}, {800, 0, 0}, {0, 0, -45});
    return all;
}

/// A plane through the middle of the picture that is slanted against every axis.
triangles slanted() {
    triangles all;
    oracle::add_quad(all, {-30, -30, -4}, {60, 3, 15}, {5, 60, -13});
    return all;
}

}

TEST_CASE("coverage: a share alpha of the samples keeps a fragment, and varies as the method promises") {
    for (const method& of : methods)
        for (unsigned samples : {1u, 3u, 8u, 16u, 24u, 32u}) {
            layer_capture capture("atomic_minimum/" + of.name, samples, side, side);
            for (float alpha : {0.05f, 0.2f, 0.5f, 0.9f}) {
                CAPTURE(of.name);
                CAPTURE(samples);
                CAPTURE(alpha);
                const mask m = coverage_of(capture, samples, slanted(), {.opacity = alpha});
                const double a = alpha, spread = std::sqrt(a * (1 - a));
                CHECK(std::abs(mean(m.kept) - a) < doubt(m, of, spread));
                const double of_strata = [&] {
                    const double part = a * std::min(samples, 16u), over = part - std::floor(part);
                    return over * (1 - over);
                }();
                if (of.strata && samples <= 16)
                    CHECK(std::abs(variance_of_count(m) - of_strata) < 0.02);
                else if (of.strata && samples == 32)
                    CHECK(std::abs(variance_of_count(m) - 2 * of_strata) < 0.04);
                else if (!of.strata)
                    CHECK(std::abs(variance_of_count(m) / (samples * a * (1 - a)) - 1) <
                          doubt_of_variance(m, of, a));
            }
        }
}

TEST_CASE("coverage: each sample keeps its share, on planes across an axis too") {
    const triangles planes[] = {oracle::wall(2), floor_below(), slanted()};
    for (const method& of : methods) {
        layer_capture capture("atomic_minimum/" + of.name, 8, side, side);
        for (const triangles& plane : planes) {
            CAPTURE(of.name);
            CAPTURE(&plane - planes);
            const mask all = coverage_of(capture, 8, plane, {.opacity = 1});
            const mask m = coverage_of(capture, 8, plane, {.opacity = 0.3f});
            for (std::size_t i = 0; i < 8; ++i) {
                CAPTURE(i);
                double kept = 0, there = 0;
                for (std::size_t t = i * m.texels(); t < (i + 1) * m.texels(); ++t) {
                    kept += m.kept[t];
                    there += all.kept[t];
                }
                CHECK(std::abs(kept / there - 0.3) < 5 * std::sqrt(0.3 * 0.7 * of.cells / there));
            }
        }
    }
}

TEST_CASE("coverage: nothing is told by a neighbour, another sample, layer or frame") {
    for (const method& of : methods) {
        CAPTURE(of.name);
        layer_capture capture("atomic_minimum/" + of.name, 8, side, side);
        const mask m = coverage_of(capture, 8, oracle::wall(2), {.opacity = 0.3f});
        // Thresholds on a surface are those of a cell, which may be two texels wide.
        const unsigned apart = of.name.ends_with("threshold") ? 4 : 1;
        CHECK(std::abs(correlation_of_texels(m, apart, 0)) < doubt(m, of));
        CHECK(std::abs(correlation_of_texels(m, 0, apart)) < doubt(m, of));
        CHECK(std::abs(correlation_of_texels(m, apart, apart)) < doubt(m, of));
        // Of 8 samples 2.4 keep the fragment: strata are 2 or 3, so that one which keeps it leaves fewer to
        // the others.
        const double p = 0.3, of_coins = 8 * p * (1 - p);
        const double expected = of.strata ? (0.4 * 0.6 - of_coins) / (7 * of_coins) : 0;
        for (unsigned samples : {1u, 2u, 5u})
            CHECK(std::abs(correlation_of_samples(m, samples) - expected) < doubt(m, of) * 1.6);
        const mask other_layer = coverage_of(capture, 8, oracle::wall(2.1f), {.opacity = 0.3f});
        CHECK(std::abs(correlation(m.kept, other_layer.kept)) < doubt(m, of));
        for (std::uint32_t frame : {1u, 2u, 32u, 1000u}) {
            CAPTURE(frame);
            const mask later = coverage_of(capture, 8, oracle::wall(2), {.opacity = 0.3f, .frame = frame});
            CHECK(std::abs(mean(later.kept) - p) < doubt(m, of, std::sqrt(p * (1 - p))));
            CHECK(std::abs(correlation(m.kept, later.kept)) < doubt(m, of));
        }
    }
}

TEST_CASE("coverage: the samples of one half of 32 tell nothing of the other") {
    layer_capture capture("atomic_minimum/stratified", 32, side, side);
    const mask m = coverage_of(capture, 32, oracle::wall(2), {.opacity = 0.3f});
    CHECK(std::abs(correlation_of_samples(m, 16)) < 5 / std::sqrt(static_cast<double>(m.kept.size() / 2)));
}

TEST_CASE("coverage: at a grazing angle cells are as wide as the texel is long, or by axes as the texel") {
    // Seen by an orthographic lens a texel is five times as long on the plane as it is wide.
    triangles plane;
    oracle::add_quad(plane, {-30, -30, 125}, {60, 0, 0}, {0, 60, -300});
    const auto alike = [&](const char* name, unsigned apart) {
        layer_capture capture(std::string("atomic_minimum/") + name, 8, side, side, lens::orthographic);
        return correlation_of_texels(coverage_of(capture, 8, plane, {.opacity = 0.3f}), apart, 0);
    };
    CHECK(alike("isotropic_threshold", 2) > 0.3);
    CHECK(std::abs(alike("anisotropic_threshold", 4)) < 0.02);
}

TEST_CASE("coverage: thresholds stay on the surface when the camera moves along it") {
    // Seen by an orthographic lens that is 4 units high, a texel is 1/64 wide.
    constexpr unsigned high = 256;
    for (const char* name : {"isotropic_threshold", "anisotropic_threshold"}) {
        CAPTURE(std::string(name));
        layer_capture capture(std::string("atomic_minimum/") + name, 8, high, high, lens::orthographic);
        capture.draw(oracle::wall(3), {.opacity = 0.3f});
        const std::vector<std::uint32_t> before = capture.runner().download_uint("captured_layers");
        capture.draw(oracle::wall(3), {.opacity = 0.3f, .moved = {5.0f / 64, 0, 0}});
        const std::vector<std::uint32_t> after = capture.runner().download_uint("captured_layers");
        std::size_t other = 0, count = 0;
        for (std::size_t i = 0; i < before.size(); ++i)
            if (i % high + 5 < high) {
                other += after[i] != before[i + 5];
                ++count;
            }
        CHECK(other < count / 100);
    }
}
