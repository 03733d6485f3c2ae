// SPDX-License-Identifier: MIT
#include "measure/structural_similarity.hpp"

#include <limits>

namespace crease::tools {
namespace {

constexpr unsigned window = 8;
constexpr double texels_in_window = window * window;

/// Sums over windows, each in constant time.
class summed_area {
public:
    template <typename Value>
    summed_area(unsigned width, unsigned height, Value value)
        : stride_(width + 1), sums_(stride_ * (height + 1)) {
        for (unsigned y = 0; y < height; ++y) {
            double row = 0;
            for (unsigned x = 0; x < width; ++x) {
                row += value(x, y);
                sums_[(y + 1) * stride_ + x + 1] = sums_[y * stride_ + x + 1] + row;
            }
        }
    }

    /// The sum over the window whose first texel is (x, y).
    double operator()(unsigned x, unsigned y) const {
        const std::size_t top = y * stride_ + x, bottom = top + window * stride_;
        return sums_[bottom + window] - sums_[bottom] - sums_[top + window] + sums_[top];
    }

private:
    std::size_t stride_;
    std::vector<double> sums_;
};

}

double structural_similarity(const image& a, const image& b, unsigned channel, const std::vector<bool>& mask,
                             double peak) {
    const unsigned width = a.width, height = a.height;
    const auto counts = [&](unsigned x, unsigned y) -> bool { return mask[std::size_t{y} * width + x]; };
    const auto value = [&](const image& from, unsigned x, unsigned y) -> double {
        return counts(x, y) ? from.at(x, y, channel) : 0.0f;
    };
    const auto sums_of = [&](auto of) { return summed_area(width, height, of); };
    const summed_area count = sums_of([&](unsigned x, unsigned y) { return counts(x, y) ? 1.0 : 0.0; });
    const summed_area sum_a = sums_of([&](unsigned x, unsigned y) { return value(a, x, y); });
    const summed_area sum_b = sums_of([&](unsigned x, unsigned y) { return value(b, x, y); });
    const summed_area sum_aa =
        sums_of([&](unsigned x, unsigned y) { return value(a, x, y) * value(a, x, y); });
    const summed_area sum_bb =
        sums_of([&](unsigned x, unsigned y) { return value(b, x, y) * value(b, x, y); });
    const summed_area sum_ab =
        sums_of([&](unsigned x, unsigned y) { return value(a, x, y) * value(b, x, y); });

    const double c1 = 0.01 * peak * 0.01 * peak, c2 = 0.03 * peak * 0.03 * peak;
    double total = 0;
    std::size_t windows = 0;
    for (unsigned y = 0; y + window <= height; ++y)
        for (unsigned x = 0; x + window <= width; ++x) {
            if (count(x, y) < texels_in_window - 0.5)
                continue;
            const double mean_a = sum_a(x, y) / texels_in_window, mean_b = sum_b(x, y) / texels_in_window;
            const double variance_a = sum_aa(x, y) / texels_in_window - mean_a * mean_a;
            const double variance_b = sum_bb(x, y) / texels_in_window - mean_b * mean_b;
            const double covariance = sum_ab(x, y) / texels_in_window - mean_a * mean_b;
            total += (2 * mean_a * mean_b + c1) * (2 * covariance + c2) /
                     ((mean_a * mean_a + mean_b * mean_b + c1) * (variance_a + variance_b + c2));
            ++windows;
        }
    return windows ? total / static_cast<double>(windows) : std::numeric_limits<double>::quiet_NaN();
}

}
