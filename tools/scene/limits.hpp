// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace crease::tools {

// What a scene may hold, so that a small file never asks for much memory or time. Checked before anything is
// expanded.

/// Bytes of a file, and of all further files that a scene names together.
inline constexpr std::size_t most_file_bytes = std::size_t{1} << 30;

/// Bytes of an .obj file's library of materials.
inline constexpr std::size_t most_library_bytes = std::size_t{1} << 24;

/// Vertices after every mesh stands wherever it is placed.
inline constexpr std::size_t most_vertices = std::size_t{1} << 24;

/// Triangles, likewise.
inline constexpr std::size_t most_triangles = std::size_t{1} << 24;

/// Steps that place all vertices: one for each vertex, each morph target and joint that may move it, each
/// instance and each joint.
inline constexpr std::size_t most_placing_steps = std::size_t{1} << 26;

}
