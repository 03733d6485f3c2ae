// SPDX-License-Identifier: MIT
#include "image/file_set.hpp"

#include "image/file.hpp"

#include <fmt/format.h>

#include <array>
#include <csignal>
#include <cstddef>
#include <random>
#include <system_error>
#include <vector>

namespace crease::tools {
namespace fs = std::filesystem;

/// While it lives, signals that end the process are kept; the last of them is raised when it ends.
class file_set::deferred_signals {
public:
    deferred_signals() {
        struct sigaction keep {};
        keep.sa_handler = [](int signal) { kept = signal; };
        sigemptyset(&keep.sa_mask);
        keep.sa_flags = SA_RESTART;
        for (std::size_t i = 0; i < signals.size(); ++i)
            sigaction(signals[i], &keep, &before_[i]);
    }
    deferred_signals(const deferred_signals&) = delete;
    deferred_signals& operator=(const deferred_signals&) = delete;
    ~deferred_signals() {
        for (std::size_t i = 0; i < signals.size(); ++i)
            sigaction(signals[i], &before_[i], nullptr);
        const int signal = kept;
        kept = 0;
        if (signal != 0)
            std::raise(signal);
    }

private:
    static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
    static inline volatile std::sig_atomic_t kept = 0;
    std::array<struct sigaction, signals.size()> before_{};
};

namespace {

/// The files below a folder, relative to it.
std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (!entry.is_directory())
            names.push_back(entry.path().lexically_relative(folder));
    return names;
}

}

file_set::file_set(fs::path folder)
    : deferred_(std::make_unique<deferred_signals>()), folder_(std::move(folder)) {
    std::error_code error;
    made_ = !fs::exists(folder_, error);
    make_directory(folder_);
    hidden_ = folder_ / fmt::format(".crease-{:08x}.part", std::random_device{}());
    if (!fs::create_directory(hidden_, error))
        throw file_error(fmt::format("{}: cannot write in this directory: {}; choose another output path",
                                     folder_.string(), error.message()));
}

file_set::~file_set() {
    std::error_code ignored;
    fs::remove_all(hidden_, ignored);
    if (made_)
        fs::remove(folder_, ignored); // stays where it holds anything
}

void file_set::appear(std::span<const std::string> older) {
    const std::vector<fs::path> names = files_below(hidden_);
    std::error_code error;
    for (const fs::path& name : names) {
        const fs::file_status there = fs::status(folder_ / name, error);
        if (fs::exists(there) && !fs::is_regular_file(there))
            throw file_error(
                fmt::format("{}: not a regular file; choose another output path", (folder_ / name).string()));
        if (name.has_parent_path())
            make_directory(folder_ / name.parent_path());
    }
    for (const std::string& name : older)
        fs::remove(folder_ / name, error);
    for (const fs::path& name : names) {
        fs::rename(hidden_ / name, folder_ / name, error);
        if (!error)
            continue;
        const std::string reason = error.message();
        for (const fs::path& each : names)
            fs::remove(folder_ / each, error);
        throw file_error(fmt::format("{}: cannot replace it: {}", (folder_ / name).string(), reason));
    }
}

}
