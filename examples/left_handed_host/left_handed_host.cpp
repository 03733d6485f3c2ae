// SPDX-License-Identifier: MIT
// An engine in the manner of Direct3D: its view space looks along +Z, clip space has y up, and its matrices
// are rows one after the other, for column vectors.
#include "camera.hpp"
#include "screen.hpp"

using ao = crease::effect<crease::directions<4, 4>, crease::single_layer, crease::hbao,
                          crease::reconstructed_normals>;

namespace {

constexpr float nearest = 0.5f, farthest = 50;
constexpr float depth_scale = farthest / (farthest - nearest);

constexpr picture::matrix projection = {1, 0,        0,           0,                     //
                                        0, 16.f / 9, 0,           0,                     //
                                        0, 0,        depth_scale, -depth_scale* nearest, //
                                        0, 0,        1,           0};

constexpr crease::matrix_convention direct3d{
    .depth_zero_to_one = true, .y_up = true, .left_handed = true, .row_major = true};

/// Its depth buffer of the corner, the highest row first.
std::vector<float> device_depth() {
    std::vector<float> texels;
    for (unsigned j = 0; j < picture::height; ++j)
        for (unsigned i = 0; i < picture::width; ++i) {
            const float x = 2 * (static_cast<float>(i) + 0.5f) / picture::width - 1;
            const float y = 1 - 2 * (static_cast<float>(j) + 0.5f) / picture::height;
            const float along = corner::depth_along(x / projection[0], y / projection[5]);
            texels.push_back(projection[10] + projection[11] / along);
        }
    return texels;
}

crease::parameters parameters() {
    crease::parameters values = ao::defaults;
    const auto fit =
        crease::set_projection(values.view, projection, picture::width, picture::height, direct3d);
    if (!fit)
        throw std::runtime_error(std::string(fit.error));
    values.radius = corner::radius;
    return values;
}

}

/// @param arguments  optionally the path of a PGM picture to write
int main(int count, char** arguments) {
    try {
        renderer gpu({.shaderStorageImageExtendedFormats = ao::features.extended_storage_formats});
        const auto visibility = render(gpu, ao::view(), parameters(), device_depth());
        if (count > 1)
            picture::write_pgm(arguments[1], visibility, true);
        return corner::plausible(visibility, camera::projection) ? 0 : 1; // the same places in the picture
    } catch (const std::exception& failure) {
        std::cerr << "left_handed_host: " << failure.what() << '\n';
        return 1;
    }
}
