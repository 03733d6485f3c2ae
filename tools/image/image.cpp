// SPDX-License-Identifier: MIT
#include "image/image.hpp"

#include <fmt/format.h>

namespace crease::tools {

image::image(unsigned texels_wide, unsigned texels_high, unsigned values_each, float fill)
    : width(texels_wide), height(texels_high), channels(values_each),
      texels(std::size_t{texels_wide} * texels_high * values_each, fill) {}

image read_image(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension)
        c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    if (extension == ".pfm")
        return read_pfm(path);
    if (extension == ".exr")
        return read_exr(path);
    throw image_error(fmt::format("{}: cannot read '{}' images; use .pfm or .exr", path.string(), extension));
}

}
