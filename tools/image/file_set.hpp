// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace crease::tools {

/// Files that come into a folder together: all of them, or none, and the folder holds what it held. Until
/// they `appear` they are in a hidden folder within it. While it lives, signals that end the process wait.
class file_set {
public:
    /// Makes the folder where it is missing.
    /// @throws file_error
    explicit file_set(std::filesystem::path folder);

    /// Removes what has not appeared, and the folder too where it was made for that.
    ~file_set();

    file_set(const file_set&) = delete;
    file_set& operator=(const file_set&) = delete;

    /// Where to write a file that is to appear as `name`, which may lie in folders of its own.
    std::filesystem::path operator/(const std::filesystem::path& name) const { return hidden_ / name; }

    /// Moves all files to their places, over what stands there.
    /// @param older  names of files that go, as they belong to what stood there before
    /// @throws file_error where one cannot be replaced; the folder then holds neither the old nor the new
    void appear(std::span<const std::string> older = {});

private:
    class deferred_signals;

    std::unique_ptr<deferred_signals> deferred_;
    std::filesystem::path folder_, hidden_;
    bool made_ = false; ///< whether the folder was missing
};

}
