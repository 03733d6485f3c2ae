// SPDX-License-Identifier: MIT
#include "image/image.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

/// The first byte picks the loader, the rest is its file. A loader may refuse by its own errors and nothing
/// else.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace crease::tools;
    if (size == 0)
        return 0;
    const std::string_view file(reinterpret_cast<const char*>(data + 1), size - 1);
    try {
        switch (data[0] % 4) {
        case 0:
            parse_cameras(file, "input");
            break;
        case 1:
            parse_pfm(file, "input");
            break;
        case 2:
            parse_mesh(file, "glb", "input");
            break;
        default:
            parse_mesh(file, "obj", "input");
        }
    } catch (const scene_error&) {
    } catch (const image_error&) {
    }
    return 0;
}
