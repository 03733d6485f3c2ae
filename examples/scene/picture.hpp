// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

/// What the examples see and say of a picture of visibility.
namespace picture {

inline constexpr unsigned width = 640, height = 360;

using matrix = float[16]; // column-major, view space to clip space

/// Mean visibility around the texel at which a point of view space is seen.
inline float mean_around(const std::vector<std::uint8_t>& visibility, const matrix& projection, float x,
                         float y, float depth) {
    constexpr int reach = 4; // the randomness of a pixel evens out over its neighbours
    const int i0 = static_cast<int>((projection[0] * x / depth * 0.5f + 0.5f) * width);
    const int j0 = static_cast<int>((projection[5] * y / depth * 0.5f + 0.5f) * height);
    float sum = 0;
    for (int j = j0 - reach; j <= j0 + reach; ++j)
        for (int i = i0 - reach; i <= i0 + reach; ++i)
            sum += visibility[static_cast<unsigned>(j) * width + static_cast<unsigned>(i)];
    return sum / (255 * (2 * reach + 1) * (2 * reach + 1));
}

/// Shares of light as they are shown.
inline std::vector<std::uint8_t> bytes_of(const std::vector<float>& visibility) {
    std::vector<std::uint8_t> bytes;
    for (float share : visibility)
        bytes.push_back(static_cast<std::uint8_t>(255 * share + 0.5f));
    return bytes;
}

/// Writes a PGM picture, top row first.
/// @throws std::runtime_error  where the file cannot be written
inline void write_pgm(const std::string& path, const std::vector<std::uint8_t>& visibility,
                      bool top_row_first) {
    std::ofstream file(path, std::ios::binary);
    file << "P5\n" << width << ' ' << height << "\n255\n";
    for (unsigned row = 0; row < height; ++row)
        for (unsigned i = 0; i < width; ++i)
            file.put(static_cast<char>(visibility[(top_row_first ? row : height - 1 - row) * width + i]));
    if (!file.flush())
        throw std::runtime_error("cannot write " + path + ": choose another path");
}

}
