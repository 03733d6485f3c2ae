// SPDX-License-Identifier: MIT
#pragma once

#include "given_layers.hpp"
#include "run.hpp"

namespace oracle {

/// The bits of a sample that keeps nothing.
inline constexpr std::uint32_t kept_nothing = ~0u;

/// What atomic_minimum would hold where the samples share out all layers of a texel in turn.
std::vector<std::uint32_t> share_out(const picture& p, unsigned samples);

/// Balls one behind another.
std::vector<surface> balls();

/// The balls before a wall, with at most so many layers at a texel.
picture many_layers(lens kind, int width, int height, std::size_t most);

/// Corners of triangles in view space, as a geometry pass draws them.
using triangles = std::vector<glm::vec3>;

/// Adds a parallelogram with a corner at `at`.
void add_quad(triangles& to, glm::vec3 at, glm::vec3 across, glm::vec3 up);

/// A rectangle that fills the picture of every lens, at a depth.
triangles wall(float depth);

/// A projection as a host's shader takes it.
glm::mat4 clip_from_view(lens kind, double aspect);

struct capture_settings {
    float opacity = 1;
    std::uint32_t frame = 0;
    glm::vec3 moved{0}; ///< by how much the anchors are from the positions
};

/// Draws triangles so that they fill the layers of an effect, all of which lie behind its depth image.
class layer_capture {
public:
    /// @param parts  the layer storage and coverage, e.g. "atomic_minimum/stratified"
    /// @param last   the last pass of the effect that runs
    layer_capture(const std::string& parts, unsigned samples, unsigned width, unsigned height,
                  lens seen_by = lens::standard, std::string_view last = "capture_layers");

    void draw(const triangles& scene, const capture_settings& how);
    crease::vulkan::runner& runner() { return runner_; }

private:
    glm::mat4 projection_;
    std::unique_ptr<crease::composition> composed_;
    crease::vulkan::runner runner_;
    crease::parameters how_;
    crease::vulkan::geometry_shaders host_;
};

}
