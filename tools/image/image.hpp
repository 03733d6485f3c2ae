// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace crease::tools {

/// An image that cannot be read or written; the message names the path, what is wrong and what would do.
struct image_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Linear floats, row 0 at the top, channels interleaved: texel (x, y) begins at (y * width + x) * channels.
struct image {
    unsigned width = 0, height = 0, channels = 0;
    std::vector<float> texels; ///< width * height * channels

    image() = default;
    image(unsigned texels_wide, unsigned texels_high, unsigned values_each = 1, float fill = 0);

    float& at(unsigned x, unsigned y, unsigned channel = 0) { return texels[index(x, y, channel)]; }
    float at(unsigned x, unsigned y, unsigned channel = 0) const { return texels[index(x, y, channel)]; }

    bool same_size(const image& other) const { return width == other.width && height == other.height; }

private:
    std::size_t index(unsigned x, unsigned y, unsigned channel) const {
        return (std::size_t{y} * width + x) * channels + channel;
    }
};

/// The longest side, in texels, of an image that is read.
inline constexpr unsigned longest_side = 16384;

/// Reads by the extension: .pfm or .exr, in letters of either case.
/// @throws file_error, image_error
image read_image(const std::filesystem::path& path);

/// PFM: 1 (`Pf`) or 3 (`PF`) channels, either byte order, any value including NaN. The number that scales the
/// values is read for its sign alone, as everybody does. Lines may end in CR LF; nothing may follow the
/// values.
/// @throws file_error, image_error
image read_pfm(const std::filesystem::path& path);

/// As `read_pfm`, from memory; `name` is what an error calls it.
/// @throws image_error
image parse_pfm(std::string_view bytes, std::string_view name);

/// Little-endian PFM of 1 or 3 channels.
/// @throws file_error, image_error
void write_pfm(const std::filesystem::path& path, const image& pixels);

/// One channel of an EXR file and the channel of an image that fills it.
struct exr_channel {
    std::string name; ///< e.g. "visibility", "depth.Z", "normal.X"
    const image& source;
    unsigned component = 0;
};

/// Flat EXR, scan lines or tiles: R, G and B as 3 channels where it has all of them; else `Y`, else
/// `visibility`.
/// @throws file_error, image_error
image read_exr(const std::filesystem::path& path);

/// 32-bit float EXR, compressed without loss. All sources have the size of the first.
/// @throws file_error, image_error
void write_exr(const std::filesystem::path& path, std::span<const exr_channel> channels);

/// 8-bit grey (1 channel) or RGB (3): the value times 255, clamped and rounded; NaN is 0.
/// @throws file_error, image_error
void write_png(const std::filesystem::path& path, const image& pixels);

}
