// SPDX-License-Identifier: MIT
#include "measure/compare.hpp"

#include "measure/structural_similarity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace crease::tools {
namespace {

void check_sizes(const image& test, const image& reference, const image* depth) {
    if (!test.same_size(reference) || test.channels != reference.channels)
        throw comparison_error(fmt::format(
            "sizes differ: the test is {} x {} x {} channels, the reference {} x {} x {}", test.width,
            test.height, test.channels, reference.width, reference.height, reference.channels));
    if (depth && (!depth->same_size(reference) || depth->channels != 1))
        throw comparison_error(
            fmt::format("the depth is {} x {} x {} channels; the reference needs {} x {} x 1", depth->width,
                        depth->height, depth->channels, reference.width, reference.height));
}

/// The depth from which on a texel is background.
float background_depth(const comparison_settings& settings) {
    float far = -std::numeric_limits<float>::infinity();
    if (settings.far)
        far = *settings.far;
    else
        for (const float depth : settings.depth->texels)
            far = std::fmax(far, depth); // passes over NaN
    return far * (1 - 1e-6f);            // a cleared texel must reach it in spite of rounding
}

/// Percentile by linear interpolation between the two nearest ranks; reorders `values`.
double percentile(std::vector<double>& values, double fraction) {
    const double rank = fraction * static_cast<double>(values.size() - 1);
    const auto lower = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), lower, values.end());
    const auto upper = lower + 1 == values.end() ? lower : std::min_element(lower + 1, values.end());
    return *lower + (rank - std::floor(rank)) * (*upper - *lower);
}

/// Gathers the differences of the texels that count.
struct gatherer {
    comparison result;
    std::vector<bool> counts;
    std::vector<double> absolute;
    double square_sum = 0, sum = 0;

    /// The largest absolute difference of a texel that is not background.
    float add(std::span<const float> test, std::span<const float> reference) {
        const auto is_finite = [](float value) { return std::isfinite(value); };
        const bool finite = std::ranges::all_of(test, is_finite) && std::ranges::all_of(reference, is_finite);
        counts.push_back(finite);
        if (!finite) {
            ++result.nonfinite;
            return std::numeric_limits<float>::infinity();
        }
        ++result.pixels;
        double largest = 0;
        for (std::size_t c = 0; c < test.size(); ++c) {
            const double d = double{test[c]} - double{reference[c]};
            sum += d;
            square_sum += d * d;
            absolute.push_back(std::abs(d));
            largest = std::max(largest, std::abs(d));
        }
        return static_cast<float>(largest);
    }

    float skip_background() {
        counts.push_back(false);
        ++result.background;
        return 0;
    }
};

}

comparison compare(const image& test, const image& reference, const comparison_settings& settings) {
    check_sizes(test, reference, settings.depth);
    const float far = settings.depth ? background_depth(settings) : 0;
    const std::size_t channels = reference.channels, texels = std::size_t{reference.width} * reference.height;
    image difference(reference.width, reference.height);
    gatherer all;
    for (std::size_t i = 0; i < texels; ++i) {
        const bool background = settings.depth && !(settings.depth->texels[i] < far);
        difference.texels[i] = background
                                   ? all.skip_background()
                                   : all.add(std::span(test.texels).subspan(i * channels, channels),
                                             std::span(reference.texels).subspan(i * channels, channels));
    }
    comparison result = all.result;
    if (all.absolute.empty())
        throw comparison_error(fmt::format("no pixels to compare: of {}, {} are background and {} not finite",
                                           texels, result.background, result.nonfinite));
    const double count = static_cast<double>(all.absolute.size());
    result.rmse = std::sqrt(all.square_sum / count);
    result.bias = all.sum / count;
    for (const double d : all.absolute)
        result.mae += d / count;
    result.psnr_db = 20 * std::log10(settings.peak / result.rmse);
    result.max_abs = *std::ranges::max_element(all.absolute);
    result.p99_abs = percentile(all.absolute, 0.99);
    for (unsigned c = 0; c < reference.channels; ++c)
        result.ssim +=
            structural_similarity(test, reference, c, all.counts, settings.peak) / reference.channels;
    if (settings.difference)
        *settings.difference = std::move(difference);
    return result;
}

double mean_angle(const image& test, const image& reference) {
    if (!test.same_size(reference) || test.channels != 3 || reference.channels != 3)
        throw comparison_error("directions can be compared only in images of one size with 3 channels");
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < test.texels.size(); i += 3) {
        double dot = 0, squared = 0, other = 0;
        for (std::size_t c = i; c < i + 3; ++c) {
            dot += double{test.texels[c]} * double{reference.texels[c]};
            squared += double{test.texels[c]} * double{test.texels[c]};
            other += double{reference.texels[c]} * double{reference.texels[c]};
        }
        if (!(squared > 0 && other > 0))
            continue;
        sum += std::acos(std::clamp(dot / std::sqrt(squared * other), -1.0, 1.0));
        ++count;
    }
    return sum / static_cast<double>(count) * 180 / std::numbers::pi;
}

}
