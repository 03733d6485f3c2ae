// SPDX-License-Identifier: MIT
#include "file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <system_error>

namespace crease::tools {

void write_file(const std::filesystem::path& path, std::string_view bytes) {
    const std::filesystem::path draft = path.string() + ".part";
    std::ofstream file(draft, std::ios::binary | std::ios::trunc);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    std::error_code failed;
    if (file)
        std::filesystem::rename(draft, path, failed);
    if (!file || failed) {
        std::error_code ignored;
        std::filesystem::remove(draft, ignored);
        throw std::runtime_error(fmt::format(
            "cannot write '{}': check that its directory is there, writable and has room", path.string()));
    }
}

void make_directory(const std::filesystem::path& path) {
    std::error_code failed;
    std::filesystem::create_directories(path, failed);
    if (failed)
        throw std::runtime_error(
            fmt::format("cannot make the directory '{}': {}", path.string(), failed.message()));
}

}
