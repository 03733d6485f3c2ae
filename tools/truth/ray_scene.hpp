// SPDX-License-Identifier: MIT
#pragma once

#include "scene/eye_mesh.hpp"

#include <embree3/rtcore.h>

#include <memory>
#include <vector>

namespace crease::tools {

/// The triangles of a mesh, ready to be hit by rays; all in its units. Safe to use from many threads.
class ray_scene {
public:
    /// Where a ray meets a surface.
    struct crossing {
        float distance; ///< the t of origin + t * direction
        float opacity;
        std::uint32_t triangle;
        float u, v; ///< barycentric coordinates in it
    };

    struct surface {
        glm::vec3 position; ///< on the triangle, to the last bit or so
        glm::vec3 normal;   ///< unit, towards the origin of the ray
        float offset;       ///< how far along the normal a ray must begin to miss its own surface
    };

    explicit ray_scene(eye_mesh source);
    ray_scene(const ray_scene&) = delete;
    ray_scene& operator=(const ray_scene&) = delete;

    /// Where origin + t * direction meets surfaces with t in [nearest, farthest], nearest first and up to the
    /// first that is opaque.
    /// @param found  filled anew, so that its memory lasts for many rays
    void trace(const glm::vec3& origin, const glm::vec3& direction, float nearest, float farthest,
               std::vector<crossing>& found) const;

    /// The surface that a ray of this direction meets there.
    surface surface_at(const crossing& at, const glm::vec3& direction) const;

private:
    struct release {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    };

    bool are_one_surface(const crossing& a, const crossing& b, float most) const;
    unsigned shared_corners(std::uint32_t a, std::uint32_t b) const;
    const glm::vec3& corner(std::uint32_t triangle, unsigned i) const {
        return source_.positions[source_.indices[3 * std::size_t{triangle} + i]];
    }

    eye_mesh source_;
    std::unique_ptr<RTCDeviceTy, release> device_;
    std::unique_ptr<RTCSceneTy, release> scene_;
};

}
