// SPDX-License-Identifier: MIT
// An engine with its own Vulkan renderer that runs one variant of crease as a compute pass.
#include "camera.hpp"
#include "screen.hpp"

using ao = crease::effect<crease::directions<4, 4>, crease::single_layer, crease::hbao,
                          crease::reconstructed_normals>;

/// @param arguments  optionally the path of a PGM picture to write
int main(int count, char** arguments) {
    try {
        renderer gpu({.shaderStorageImageExtendedFormats = ao::features.extended_storage_formats});
        const auto visibility = render(gpu, ao::view(), camera::parameters_for(ao::view()), camera::depth());
        if (count > 1)
            picture::write_pgm(arguments[1], visibility, true);
        return corner::plausible(visibility, camera::projection) ? 0 : 1;
    } catch (const std::exception& failure) {
        std::cerr << "vulkan_host: " << failure.what() << '\n';
        return 1;
    }
}
