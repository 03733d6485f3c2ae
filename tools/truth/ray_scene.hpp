// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

#include <embree3/rtcore.h>

#include <limits>
#include <memory>
#include <optional>

namespace crease::tools {

/// The triangles of a mesh, ready to be hit by rays. Safe to use from many threads.
class ray_scene {
public:
    struct surface {
        glm::vec3 position; ///< on the triangle, to the last bit or so
        glm::vec3 normal;   ///< unit, towards the origin of the ray
        float offset;       ///< how far along the normal a ray must begin to miss its own surface
    };

    /// @param source must outlive this, and pass `check_mesh`
    explicit ray_scene(const mesh& source);

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

    const mesh& source_;
    std::unique_ptr<RTCDeviceTy, release> device_;
    std::unique_ptr<RTCSceneTy, release> scene_;
};

}
