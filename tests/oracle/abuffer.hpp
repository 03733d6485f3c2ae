// SPDX-License-Identifier: MIT
// All fragments of triangles, in double precision and apart from the shaders, and effects that capture them.
#pragma once

#include "captured.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace oracle {

struct fragment {
    double depth;             ///< linear
    bool back;                ///< of a back face: its corners turn clockwise
    std::size_t triangle = 0; ///< of those that were drawn, where it is known

    bool operator==(const fragment&) const = default;
};

/// A fragment with its surface, as a depth source keeps it.
struct surface_fragment {
    double depth; ///< linear
    bool back;
    std::uint32_t color; ///< four bytes, red first; the last is the opacity
    glm::dvec3 normal;
};

/// Sixteen colours, four bytes each, red first; the last is the opacity.
using color_table = std::array<std::uint32_t, 16>;

/// Colours of many opacities, of which the fourth is 0 and the eighth 255.
color_table every_color();

/// The fragments of each texel, row by row, nearest first.
struct fragment_lists {
    std::vector<std::vector<fragment>> of;
    std::vector<bool> doubtful; ///< an edge passes so near the centre that rounding may decide
};

/// What a rasteriser makes of triangles that lie beyond the near plane.
fragment_lists rasterise(const triangles& scene, lens seen_by, int width, int height);

/// Triangles at random, each a good part of the picture large and at a depth from 1 to 6.
triangles soup(unsigned count, std::uint32_t seed);

/// The triangles once more, with their corners in the other order.
triangles turned(const triangles& scene);

/// Triangles with a name that a failing test can give.
struct named_triangles {
    std::string name;
    triangles drawn;
};

/// Triangles with 0 to 64 fragments and more at a texel, coplanar ones and such as cut each other.
std::vector<named_triangles> fragment_scenes();

/// An effect whose depth source captures all fragments of triangles.
class fragment_capture {
public:
    /// @param recipe      the sampler, the depth source, the estimator and more, all but the depth encoding
    /// and normals
    /// @param last        the last pass that runs; where it is the packing, the depth image is before all
    /// @param free_nodes  of a pool that is in use but for these, of `linear_lists` all that the pool has,
    /// and then at least 1; else all are free
    /// @param normals     where those of receivers come from that are no captured surfaces
    /// @param rubbish     bits with which all is filled, before each frame, that an effect need not clear
    fragment_capture(const std::string& recipe, unsigned width, unsigned height,
                     lens seen_by = lens::standard, std::string_view last = "pack_layers",
                     std::optional<unsigned> free_nodes = {}, std::optional<std::uint32_t> rubbish = {},
                     std::string_view normals = "reconstructed_normals");

    /// @param colors  of the triangles, in turn, where the effect captures surfaces
    void draw(const triangles& scene, const color_table& colors = every_color()) {
        draw(scene, scene, colors);
    }
    /// Draws one scene in the first geometry pass and in those of static surfaces, and another in the others.
    void draw(const triangles& first, const triangles& others, const color_table& colors = every_color());
    crease::vulkan::runner& runner() { return *runner_; }
    crease::effect_view effect() const { return composed_->view(); }
    const crease::parameters& parameters() const { return how_; }
    /// Sets a setting, or the radius.
    void set(std::string_view name, float value);
    /// The number in a buffer of one.
    std::uint32_t count_in(std::string_view buffer) const;
    /// What is packed for a texel, row by row: nearest first.
    std::vector<std::vector<fragment>> packed(std::size_t layers) const;
    /// What receivers read of a texel, row by row: nearest first.
    std::vector<std::vector<surface_fragment>> surfaces() const;
    /// What a layer compression keeps of a texel, row by row: nearest first, without colours.
    std::vector<std::vector<surface_fragment>> nodes() const;
    /// The opacities of the packed layers of a texel, nearest first; as many as there are surfaces.
    std::vector<std::vector<std::uint32_t>> opacities() const;
    /// What is in the list of a texel, its nearest included, in the order of keys; a linked list that does
    /// not end fails the test.
    std::vector<std::vector<fragment>> listed() const;

private:
    using keys_of_texels = std::vector<std::vector<std::uint32_t>>; ///< the nearest first

    keys_of_texels linked() const;
    keys_of_texels linear() const;
    std::vector<std::uint32_t> words_in(std::string_view buffer) const;
    bool has(std::string_view resource) const;

    unsigned width_, height_;
    glm::mat4 projection_;
    std::unique_ptr<crease::composition> composed_;
    std::vector<crease::resource> resources_;
    std::unique_ptr<crease::vulkan::runner> runner_;
    crease::parameters how_;
    crease::vulkan::geometry_shaders host_;
};

/// The visibility that a recipe gives of triangles, whose nearest fragments are the receivers.
/// @param first   what is drawn in the first geometry pass
/// @param others  what is drawn in those after it
std::vector<float> visibility_of(const std::string& recipe, const triangles& first, const triangles& others,
                                 std::optional<float> thickness = {});

}
