// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace crease::tools {

/// A scene or camera list that cannot be used; the message names the file, what is wrong and what would do.
struct scene_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// No coordinate may be farther from 0, so that squares and products of coordinates stay finite.
inline constexpr double farthest_coordinate = 1e30;

/// What a surface looks like. Of textures nothing is read.
struct material {
    glm::vec4 colour{1}; ///< linear, 0 to 1; alpha is the opacity: the share of the light that it stops

    bool operator==(const material&) const = default;
};

/// Triangles that stand one after another in a mesh, by the name that the scene gives them.
struct named_triangles {
    std::string name;
    std::size_t first, end; ///< behind the last

    bool operator==(const named_triangles&) const = default;
};

/// Triangles in world space, every one two-sided.
struct mesh {
    std::vector<glm::dvec3> positions{};       ///< world space, none beyond `farthest_coordinate`
    std::vector<std::uint32_t> indices{};      ///< three a triangle
    std::vector<material> materials{};         ///< that triangles are of
    std::vector<std::uint32_t> material_ids{}; ///< of the first triangles, places in `materials`; the others
                                               ///< are white and opaque
    std::vector<named_triangles> named{}; ///< of a node of glTF and all below it, or of an object or a group
                                          ///< of OBJ; a name may stand for several
    std::vector<bool> dynamic{};          ///< of the first triangles, whether they move; the others do not

    std::size_t triangles() const { return indices.size() / 3; }
    /// What a triangle is of.
    material material_of(std::size_t triangle) const {
        return triangle < material_ids.size() ? materials[material_ids[triangle]] : material();
    }
};

/// @throws scene_error where `scene` has no triangle, a position that is not finite or too far from 0, an
/// index out of range, or a colour that is no colour;
///         `name` is what the message calls it
void check_mesh(const mesh& scene, std::string_view name);

/// Makes all triangles that have no material yet of this one.
void paint(mesh& to, const material& with);

/// Makes triangles of a mesh dynamic.
void set_dynamic(mesh& of, std::size_t first, std::size_t end);

/// The scene with the triangles of these names dynamic, beside those that are.
/// @param label  what the message calls the scene
/// @throws scene_error where no triangle has a name, which lists those there are
mesh with_dynamic(mesh scene, std::span<const std::string> names, std::string_view label);

/// Whether something is seen through one of the triangles.
bool is_transparent(const mesh& scene);

/// The scene with this opacity for each surface that was opaque.
/// @param opacity  above 0, at most 1
mesh with_opacity(mesh scene, float opacity);

/// Adds a triangle of three of the positions that a mesh has; one without area is left out.
/// @throws scene_error, without the name of a file, where the mesh becomes too large
void add_triangle(mesh& to, std::uint32_t a, std::uint32_t b, std::uint32_t c);

/// Reads .glb, .gltf (2.0) or .obj, as `read_gltf` and `read_obj` say, and in a time and memory that do not
/// depend on what a broken file declares. Triangles without area are left out.
/// @throws scene_error; file_error
mesh load_mesh(const std::filesystem::path& path);

/// As `load_mesh`, from memory and of one self-contained file.
/// @param extension "glb", "gltf" or "obj", in any case
/// @param name      what an error calls it
/// @throws scene_error
mesh parse_mesh(std::string_view bytes, std::string_view extension, std::string_view name);

/// A camera. World units; right-handed; view space looks down -Z with +Y up.
struct camera {
    std::string name;
    glm::dvec3 eye{0}, target{0, 0, -1}, up{0, 1, 0};
    float vfov_deg = 60;                 ///< vertical field of view of a centred picture, in (0, 180)
    float near = 0.1f;                   ///< > 0
    float far = 100;                     ///< > near
    unsigned width = 1280, height = 720; ///< texels, 1 to 16384
    float ao_radius = 1;                 ///< a sensible world-space radius for what it sees, >= 0
    bool orthographic =
        false;           ///< parallel rays; the picture is as high as the field of view is at the target
    glm::dvec2 shift{0}; ///< of the picture's middle away from the axis, in its widths to the right and its
                         ///< heights up; off-centre where it is not 0
};

/// The rectangle of view space that a picture shows: at depth 1, or of an orthographic camera at any depth.
struct view_window {
    glm::dvec2 middle, half; ///< half its width and height

    /// Where in the picture a point lies: -1 to 1 in both, up and to the right.
    glm::dvec2 place_of(const glm::dvec2& xy) const { return (xy - middle) / half; }
};

/// @param aspect  width / height of the picture
view_window window_of(const camera& from, double aspect);

/// Reads a JSON list of cameras: objects with exactly the names of `camera`'s members up to `ao_radius`.
/// @throws scene_error, which names the camera and the field; file_error
std::vector<camera> load_cameras(const std::filesystem::path& path);

/// As `load_cameras`, from text; `name` is what an error calls it.
/// @throws scene_error
std::vector<camera> parse_cameras(std::string_view json, std::string_view name);

/// A camera in front of a scene, to its right and above it, that sees all of it; its radius is a tenth of
/// that of the sphere around the scene.
camera fitted_camera(const mesh& scene);

/// @throws scene_error that lists the names there are
const camera& find_camera(std::span<const camera> cameras, std::string_view name);

/// World space to view space, directions alone.
glm::dmat3 view_rotation(const camera& from);

/// World space to view space.
glm::dmat4 view_matrix(const camera& from);

/// A courtyard that shows what ambient occlusion meets: an inner corner, stairs, an arcade, thin bars before
/// a wall, curved and slanted surfaces, open sky, and a pillar that hides occluders from the first camera.
/// Metres, +Y up.
mesh built_in_scene();

/// The first is "overview".
std::vector<camera> built_in_cameras();

/// A room that shows what opacity does to ambient occlusion: a car of thin glass with an opaque interior, a
/// solid block and a ball of glass, panes of several opacities, on an opaque floor before opaque walls.
/// Metres, +Y up.
mesh glass_scene();

/// The first is "showroom".
std::vector<camera> glass_cameras();

}
