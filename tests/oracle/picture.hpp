// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace oracle {

/// What a renderer would hand to an effect: a small analytic scene, seen through a projection matrix.
struct picture {
    int width = 0, height = 0;
    glm::dmat4 projection{1};  ///< view space to Vulkan clip space
    bool reversed = false;     ///< device depth 0 is far
    std::vector<float> device; ///< depth in [0, 1], row 0 first; the clear value where there is background
    std::vector<std::vector<float>>
        hidden;                     ///< of each texel the depths behind, nearest first; empty: none has any
    std::vector<glm::vec3> normals; ///< view space, unit, facing the camera

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
    double clear_value() const { return reversed ? 0 : 1; }
    bool background(int x, int y) const { return device[index(x, y)] == static_cast<float>(clear_value()); }

    /// View-space position of a device depth at texel coordinates (centres at .5), by the inverse of the
    /// matrix.
    glm::dvec3 unproject(glm::dvec2 texel, double z) const;
    glm::dvec3 position(int x, int y) const { return unproject({x + 0.5, y + 0.5}, device[index(x, y)]); }
    /// Of all layers of a texel, the front one first.
    std::vector<glm::dvec3> positions(int x, int y) const;
    /// Texel coordinates of a view-space position.
    glm::dvec2 project(glm::dvec3 position) const;
    /// The ray of a texel: a point on it, and its direction away from the eye, unit.
    void ray(glm::dvec2 texel, glm::dvec3& origin, glm::dvec3& direction) const;
    bool is_perspective() const { return projection[3][3] == 0; }
    /// From a view-space position to the eye, unit.
    glm::dvec3 to_eye(glm::dvec3 position) const;
};

/// An anamorphic one is orthographic, of texels that are no squares, whose diagonals meet no corners.
enum class lens { standard, reversed, infinite, off_centre, orthographic, anamorphic };

/// Projection of a lens with the near plane at 0.1 and the far plane, where there is one, at 50.
glm::dmat4 make_projection(lens kind, double aspect);

/// A surface to look at.
struct surface {
    enum class kind {
        plane,
        half_plane,
        sphere,
        inside_of_sphere
    } shape;           ///< a half plane: where x > point.x
    glm::dvec3 point;  ///< on the plane, or the centre
    glm::dvec3 normal; ///< of the plane
    double radius = 0;
};

/// The nearest point that a ray meets, and the surface's normal there; false where it
/// meets nothing within 200. `direction` is unit.
bool first_hit(const std::vector<surface>& surfaces, glm::dvec3 origin, glm::dvec3 direction,
               glm::dvec3& position, glm::dvec3& normal);

/// Draws surfaces: the nearest that a texel's ray meets beyond the near plane.
picture draw(const std::vector<surface>& surfaces, lens kind, int width, int height);

/// The same, and what lies behind the nearest.
picture draw_all(const std::vector<surface>& surfaces, lens kind, int width, int height);

/// A floor, a wall, a slanted plane and two spheres: contact, corners, gaps and background.
std::vector<surface> still_life();

}
