// SPDX-License-Identifier: MIT
#pragma once

#include "emission.hpp"

#include <filesystem>

namespace crease::tools {

/// What an emission consists of, as JSON: docs/manifest.md has its members.
/// @param files  all that belong to it, but for the manifest
std::string manifest(const emission& of, const std::vector<std::string>& files);

/// The files that a manifest names; none where there is no such file.
/// @throws std::runtime_error  where it is no manifest of crease, so that nothing of another's is removed
std::vector<std::string> files_of_manifest(const std::filesystem::path& path);

/// The file that holds the texels of a constant, beside shaders that are files.
std::string texel_file(const resource& constant);

}
