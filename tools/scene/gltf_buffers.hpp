// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf_json.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace crease::tools {

/// The parts of a .glb file; a .gltf file is JSON alone.
struct gltf_container {
    std::string_view json;
    std::optional<std::string_view> data; ///< the binary chunk
};

/// @throws scene_error where the lengths that a .glb declares do not fit the file
gltf_container open_gltf(std::string_view file);

/// The bytes that accessors view: of the binary chunk, of data URIs and of further files.
class gltf_buffers {
public:
    /// @param root    the whole JSON; outlives this
    /// @param folder  where further files are; null where none may be read
    gltf_buffers(const gltf_value& root, std::optional<std::string_view> data,
                 const std::filesystem::path* folder);

    struct view {
        std::string_view bytes;
        std::size_t stride = 0; ///< bytes from element to element; 0: without gaps
    };

    /// Element `i` of "bufferViews", valid as long as this is.
    /// @throws scene_error; file_error
    view buffer_view(std::size_t i);

private:
    std::string_view buffer(std::size_t i);
    std::string read_uri(const gltf_value& buffer, std::size_t length);

    const gltf_value& root_;
    std::optional<std::string_view> data_;
    const std::filesystem::path* folder_;
    std::vector<std::optional<std::string>> read_; ///< by buffer
    std::size_t bytes_read_ = 0;
};

}
