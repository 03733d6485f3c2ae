// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

/// The built-in scene and its first camera, made `size` times as large and then moved to `place`.
struct placed_scene {
    crease::tools::mesh triangles = crease::tools::built_in_scene();
    crease::tools::camera from = crease::tools::built_in_cameras().front();

    explicit placed_scene(double size, const glm::dvec3& place = glm::dvec3(0)) {
        for (glm::dvec3& p : triangles.positions)
            p = p * size + place;
        from.eye = from.eye * size + place;
        from.target = from.target * size + place;
        for (float* length : {&from.near, &from.far, &from.ao_radius})
            *length = static_cast<float>(*length * size);
        from.width = 96;
        from.height = 54;
    }
};

/// What `depth` is in the scene of size 1.
inline crease::tools::image shrunk(crease::tools::image depth, double size) {
    for (float& texel : depth.texels)
        texel = static_cast<float>(texel / size);
    return depth;
}
