// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace crease::tools {

/// A file that cannot be opened, read or written; the message names the path and the system's reason.
struct file_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The whole content of a regular file.
/// @throws file_error where it is missing, not a regular file or unreadable
std::string read_file(const std::filesystem::path& path);

/// Puts `content` at `path`, whole or not at all: it is written beside the target, then renamed over it. A
/// link is followed; what stood there before stays until the rename.
/// @throws file_error where the directory is missing or unwritable, the disk is full, or `path` is not a
/// regular file
void write_atomically(const std::filesystem::path& path, std::string_view content);

/// Makes a directory and those above it; one that is there already will do.
/// @throws file_error
void make_directory(const std::filesystem::path& path);

}
