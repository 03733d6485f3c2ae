// SPDX-License-Identifier: MIT
#include "image/file.hpp"
#include "image/image.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cstdint>

namespace crease::tools {
namespace {

std::uint8_t to_byte(float value) {
    return value > 0 ? static_cast<std::uint8_t>(std::min(value, 1.0f) * 255 + 0.5f) : std::uint8_t{0};
}

}

void write_png(const std::filesystem::path& path, const image& pixels) {
    if (pixels.channels != 1 && pixels.channels != 3)
        throw image_error(
            fmt::format("{}: a PNG of 1 or 3 channels is written, not {}", path.string(), pixels.channels));
    std::vector<std::uint8_t> bytes(pixels.texels.size());
    std::transform(pixels.texels.begin(), pixels.texels.end(), bytes.begin(), to_byte);

    png_image description{};
    description.version = PNG_IMAGE_VERSION;
    description.width = pixels.width;
    description.height = pixels.height;
    description.format = pixels.channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
    std::string file(PNG_IMAGE_PNG_SIZE_MAX(description), '\0');
    png_alloc_size_t size = file.size();
    if (!png_image_write_to_memory(&description, file.data(), &size, 0, bytes.data(), 0, nullptr))
        throw image_error(fmt::format("{}: cannot make the PNG: {}", path.string(), description.message));
    file.resize(size);
    write_atomically(path, file);
}

}
