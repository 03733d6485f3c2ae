// SPDX-License-Identifier: MIT
#pragma once

#include "image/image.hpp"

#include <optional>

namespace crease::tools {

/// Images that cannot be compared: other sizes, or no pixel left.
struct comparison_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// How far an image is from its reference, over the pixels that are neither background nor broken.
struct comparison {
    std::size_t pixels = 0;     ///< that were compared
    std::size_t background = 0; ///< left out by the depth
    std::size_t nonfinite = 0;  ///< not background, but NaN or infinite in either image; left out
    double rmse = 0;            ///< root of the mean square difference, over all channels
    double mae = 0;             ///< mean absolute difference
    double bias = 0;            ///< mean of test - reference
    double psnr_db = 0;         ///< 20 log10(peak / rmse); infinite where rmse is 0
    double ssim = 0;            ///< structural similarity, see `structural_similarity`
    double p99_abs = 0;         ///< 99th percentile of the absolute difference, interpolated
    double max_abs = 0;         ///< largest absolute difference
};

struct comparison_settings {
    const image* depth = nullptr;  ///< 1 channel, linear view depth; without it no pixel is background
    std::optional<float> far = {}; ///< a depth at or beyond it is background; without it the largest depth is
    double peak = 1;               ///< the range of the values
    image* difference = nullptr;   ///< receives 1 channel: the largest |test - reference| of a texel's
                                   ///< channels; 0 in the background, infinite where either is not finite
};

/// @param test,reference same width, height and channels
/// @throws comparison_error
comparison compare(const image& test, const image& reference, const comparison_settings& settings = {});

/// Degrees between the directions of two images of 3 channels: the mean over the pixels where neither is 0;
/// NaN where there is none.
/// @throws comparison_error
double mean_angle(const image& test, const image& reference);

}
