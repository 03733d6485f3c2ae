// SPDX-License-Identifier: MIT
#include "image/image.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

/// An image is either refused or has the texels that its size says.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const crease::tools::image read =
            crease::tools::parse_pfm({reinterpret_cast<const char*>(data), size}, "input");
        if (read.texels.size() != std::size_t{read.width} * read.height * read.channels)
            std::abort();
    } catch (const crease::tools::image_error&) {
    }
    return 0;
}
