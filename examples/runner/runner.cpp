// SPDX-License-Identifier: MIT
// The shortest way from a depth buffer to a picture of visibility: the runner, which has a device of its own.
#include "camera.hpp"

#include <crease/crease.hpp>
#include <crease/vulkan.hpp>

using ao = crease::effect<crease::directions<4, 4>, crease::single_layer, crease::hbao,
                          crease::reconstructed_normals, crease::bilateral<>>;

/// @param arguments  optionally the path of a PGM picture to write
int main(int count, char** arguments) {
    try {
        crease::vulkan::device device;
        crease::vulkan::runner runner(device, ao::view(), picture::width, picture::height);
        runner.upload("depth", camera::depth());
        runner.run(camera::parameters_for(ao::view()));
        const auto visibility = picture::bytes_of(runner.download("visibility"));
        if (count > 1)
            picture::write_pgm(arguments[1], visibility, true);
        return corner::plausible(visibility, camera::projection) ? 0 : 1;
    } catch (const std::exception& failure) {
        std::cerr << "runner: " << failure.what() << '\n';
        return 1;
    }
}
