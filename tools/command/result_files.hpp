// SPDX-License-Identifier: MIT
#pragma once

#include "image/file_set.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace crease::tools {

/// What a command leaves in a folder: files that appear together, and meta.json, which names them. Those that
/// an earlier meta.json names go.
class result_files {
public:
    /// @throws file_error
    explicit result_files(const std::filesystem::path& folder);

    /// Where to write one.
    std::filesystem::path add(const std::string& name);

    /// @param meta    what meta.json says beside the version of crease and the names
    /// @param inputs  files that were read, which stay
    /// @throws file_error where an input would be replaced, or a file cannot be
    void appear(const nlohmann::ordered_json& meta, std::span<const std::filesystem::path> inputs);

private:
    std::filesystem::path folder_;
    file_set files_;
    std::vector<std::string> names_;
};

}
