// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace crease::tools {

/// Writes a whole file, by way of a temporary one beside it, so that no partial file is left looking whole.
/// @throws std::runtime_error  naming the path, where it cannot be written
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Makes a directory and those above it.
/// @throws std::runtime_error  naming the path, where it cannot be made
void make_directory(const std::filesystem::path& path);

}
