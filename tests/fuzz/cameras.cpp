// SPDX-License-Identifier: MIT
#include "scenes.hpp"

#include <glm/matrix.hpp>

#include <cmath>

/// Cameras are either refused or see something: their view is a rotation.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        for (const crease::tools::camera& each : crease::tools::parse_cameras(text_of(data, size), "input"))
            if (!(std::abs(glm::determinant(crease::tools::view_rotation(each)) - 1) < 1e-6))
                std::abort();
    } catch (const crease::tools::scene_error&) {
    }
    return 0;
}
