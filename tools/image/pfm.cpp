// SPDX-License-Identifier: MIT
#include "image/file.hpp"
#include "image/image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

namespace crease::tools {
namespace {

constexpr bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// Takes the next word of the header off the front of `bytes`, with the white space before it.
std::string_view take_word(std::string_view& bytes) {
    const auto begin = std::find_if_not(bytes.begin(), bytes.end(), is_space);
    const auto end = std::find_if(begin, bytes.end(), is_space);
    const std::string_view word(begin, end);
    bytes.remove_prefix(static_cast<std::size_t>(end - bytes.begin()));
    return word;
}

template <typename Number>
bool parse(std::string_view word, Number& number) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && end == word.data() + word.size();
}

void swap_bytes(std::vector<float>& values) {
    for (float& value : values)
        value = std::bit_cast<float>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value)));
}

/// Between row 0 at the top and row 0 at the bottom, either way.
void flip_rows(image& pixels) {
    const std::ptrdiff_t row = std::ptrdiff_t{pixels.width} * pixels.channels;
    auto top = pixels.texels.begin(), bottom = pixels.texels.end();
    for (unsigned y = 0; y < pixels.height / 2; ++y, top += row)
        std::swap_ranges(top, top + row, bottom -= row);
}

}

image read_pfm(const std::filesystem::path& path) {
    return parse_pfm(read_file(path), path.string());
}

image parse_pfm(std::string_view bytes, std::string_view name) {
    const std::string_view whole = bytes, magic = take_word(bytes);
    if (magic != "PF" && magic != "Pf")
        throw image_error(fmt::format("{}: not a PFM file: it must begin with 'PF' or 'Pf'", name));
    unsigned width = 0, height = 0;
    float scale = 0;
    if (!parse(take_word(bytes), width) || !parse(take_word(bytes), height) ||
        !parse(take_word(bytes), scale) || scale == 0 || !std::isfinite(scale) || bytes.empty())
        throw image_error(
            fmt::format("{}: broken PFM header: width, height and a number that is not 0 must follow "
                        "the first line",
                        name));
    if (width == 0 || height == 0 || width > longest_side || height > longest_side)
        throw image_error(
            fmt::format("{}: {} x {} texels; both must be 1 to {}", name, width, height, longest_side));
    const unsigned channels = magic == "PF" ? 3 : 1;
    const std::size_t size = std::size_t{width} * height * channels * sizeof(float);
    // One character ends the header, whatever the values begin with, unless its other lines end with two.
    const std::string_view header = whole.substr(0, whole.size() - bytes.size());
    const bool two = header.find("\r\n") != std::string_view::npos && bytes.starts_with("\r\n");
    bytes.remove_prefix(two ? 2 : 1);
    if (bytes.size() < size)
        throw image_error(fmt::format("{}: truncated: {} x {} x {} floats are {} bytes, the file has {}",
                                      name, width, height, channels, size, bytes.size()));
    if (bytes.size() > size)
        throw image_error(fmt::format("{}: {} x {} x {} floats are {} bytes, and {} more follow them; write "
                                      "one picture a file",
                                      name, width, height, channels, size, bytes.size() - size));
    image pixels(width, height, channels);
    std::memcpy(pixels.texels.data(), bytes.data(), size);
    if ((scale < 0) != (std::endian::native == std::endian::little))
        swap_bytes(pixels.texels);
    flip_rows(pixels);
    return pixels;
}

void write_pfm(const std::filesystem::path& path, const image& pixels) {
    if (pixels.channels != 1 && pixels.channels != 3)
        throw image_error(
            fmt::format("{}: PFM holds 1 or 3 channels, not {}", path.string(), pixels.channels));
    image flipped = pixels;
    flip_rows(flipped);
    if constexpr (std::endian::native == std::endian::big)
        swap_bytes(flipped.texels);
    std::string file =
        fmt::format("{}\n{} {}\n-1.0\n", pixels.channels == 3 ? "PF" : "Pf", pixels.width, pixels.height);
    file.append(reinterpret_cast<const char*>(flipped.texels.data()), flipped.texels.size() * sizeof(float));
    write_atomically(path, file);
}

}
