// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <string_view>
#include <vector>

namespace crease::tools {

/// The nodes of a glTF file with their transforms as written, of which Assimp keeps 32 bits: too few for map
/// coordinates.
struct gltf_nodes {
    struct node {
        glm::dmat4 to_parent{1};
        std::vector<std::size_t> children;
    };
    std::vector<node> all;
    std::vector<std::size_t> roots; ///< of the scene that is shown

    /// The nodes at the top as Assimp has them: one root, or a node of its own that holds all roots.
    node top() const;
};

/// @param file  the bytes of a .glb or .gltf file
/// @return no roots where it cannot be read
gltf_nodes read_gltf_nodes(std::string_view file);

}
