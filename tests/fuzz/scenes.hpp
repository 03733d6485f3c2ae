// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// A scene is either refused by the error that says so, and in one line, or is one that `check_mesh` accepts.
inline void read_scene(std::string_view file, std::string_view extension) {
    try {
        check_mesh(crease::tools::parse_mesh(file, extension, "input"), "input");
    } catch (const crease::tools::scene_error& error) {
        const std::string_view sentence = error.what();
        if (!sentence.starts_with("input: ") || sentence.size() > 400 || sentence.find('\n') != sentence.npos)
            std::abort();
    }
}
