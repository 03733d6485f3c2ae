// SPDX-License-Identifier: MIT
#pragma once

#include "scene/eye_mesh.hpp"

#include <embree3/rtcore.h>

#include <limits>
#include <memory>
#include <optional>

namespace crease::tools {

/// The triangles of a mesh, ready to be hit by rays; all in its units. Safe to use from many threads.
class ray_scene {
public:
    struct surface {
        glm::vec3 position; ///< on the triangle, to the last bit or so
        glm::vec3 normal;   ///< unit, towards the origin of the ray
        float offset;       ///< how far along the normal a ray must begin to miss its own surface
    };

    explicit ray_scene(eye_mesh source);

    /// What origin + t * direction meets first, with t in [nearest, farthest].
    std::optional<surface> first_hit(const glm::vec3& origin, const glm::vec3& direction, float nearest,
                                     float farthest) const;

    /// The t at which origin + t * direction meets a triangle first, with t in [0, farthest]; infinite where
    /// it meets none.
    float distance(const glm::vec3& origin, const glm::vec3& direction, float farthest) const;

private:
    struct release {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    };

    eye_mesh source_;
    std::unique_ptr<RTCDeviceTy, release> device_;
    std::unique_ptr<RTCSceneTy, release> scene_;
};

}
