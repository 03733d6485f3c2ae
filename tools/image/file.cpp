// SPDX-License-Identifier: MIT
#include "image/file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <random>
#include <system_error>
#include <utility>

namespace crease::tools {
namespace fs = std::filesystem;

namespace {

std::string reason(int error) {
    return std::generic_category().message(error);
}

/// A new file that disappears again unless it is renamed to its target.
class temporary_file {
public:
    explicit temporary_file(const fs::path& target)
        : target_(target),
          path_(target.parent_path() / fmt::format(".crease-{:08x}.part", std::random_device{}())),
          stream_(std::fopen(path_.c_str(), "wbx")) {
        if (!stream_)
            throw file_error(fmt::format("{}: cannot write in this directory: {}; choose another output path",
                                         target.string(), reason(errno)));
    }
    temporary_file(const temporary_file&) = delete;
    temporary_file& operator=(const temporary_file&) = delete;
    ~temporary_file() {
        if (stream_)
            std::fclose(stream_);
        std::error_code ignored;
        fs::remove(path_, ignored);
    }

    void write(std::string_view content) {
        const bool written = std::fwrite(content.data(), 1, content.size(), stream_) == content.size();
        // Closing flushes, and that is where a full disk shows; a failed write has set errno already.
        const int write_error = written ? 0 : errno;
        const bool closed = std::fclose(std::exchange(stream_, nullptr)) == 0;
        if (!written || !closed)
            throw file_error(fmt::format("{}: cannot write {} bytes: {}; is there room on the disk?",
                                         target_.string(), content.size(),
                                         reason(written ? errno : write_error)));
    }

    void become_target() {
        std::error_code error;
        fs::rename(path_, target_, error);
        if (error)
            throw file_error(fmt::format("{}: cannot replace it: {}", target_.string(), error.message()));
    }

private:
    fs::path target_, path_;
    std::FILE* stream_;
};

}

std::string read_file(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found)
        throw file_error(fmt::format("{}: no such file", path.string()));
    if (status.type() != fs::file_type::regular)
        throw file_error(fmt::format("{}: not a regular file", path.string()));
    std::ifstream stream(path, std::ios::binary | std::ios::ate);
    if (!stream)
        throw file_error(fmt::format("{}: cannot open: {}", path.string(), reason(errno)));
    std::string content(static_cast<std::size_t>(stream.tellg()), '\0');
    stream.seekg(0);
    if (!stream.read(content.data(), static_cast<std::streamsize>(content.size())))
        throw file_error(fmt::format("{}: cannot read {} bytes", path.string(), content.size()));
    return content;
}

void write_atomically(const fs::path& path, std::string_view content) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    // Renaming onto a device such as /dev/null would replace the device.
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw file_error(fmt::format("{}: not a regular file; choose another output path", path.string()));
    temporary_file file(fs::exists(status) ? fs::canonical(path) : path);
    file.write(content);
    file.become_target();
}

void make_directory(const std::filesystem::path& path) {
    std::error_code failed;
    std::filesystem::create_directories(path, failed);
    if (failed)
        throw file_error("cannot make the directory '" + path.string() + "': " + failed.message());
}

}
