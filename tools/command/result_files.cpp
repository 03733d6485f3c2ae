// SPDX-License-Identifier: MIT
#include "result_files.hpp"

#include "image/file.hpp"

#include <crease/effect/version.hpp>

#include <fmt/format.h>

namespace crease::tools {

namespace {

constexpr const char* meta_name = "meta.json";

/// The files that the meta.json of an earlier run names, as far as they lie beside it.
std::vector<std::string> files_of_earlier_run(const std::filesystem::path& folder) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(folder / meta_name, ignored))
        return {};
    const nlohmann::json meta = nlohmann::json::parse(read_file(folder / meta_name), nullptr, false);
    std::vector<std::string> names;
    if (!meta.is_object() || !meta.contains("crease") || !meta.contains("files") || !meta["files"].is_array())
        return names;
    for (const nlohmann::json& name : meta["files"])
        if (const std::string text = name.is_string() ? name.get<std::string>() : "";
            !text.empty() && std::filesystem::path(text).filename().string() == text)
            names.push_back(text);
    return names;
}

}

result_files::result_files(const std::filesystem::path& folder) : folder_(folder), files_(folder) {}

std::filesystem::path result_files::add(const std::string& name) {
    names_.push_back(name);
    return files_ / name;
}

void result_files::appear(const nlohmann::ordered_json& meta, std::span<const std::filesystem::path> inputs) {
    const std::vector<std::string> older = files_of_earlier_run(folder_);
    nlohmann::ordered_json whole{{"crease", std::string(version)}, {"files", names_}};
    whole["files"].push_back(meta_name);
    whole.update(meta);
    write_atomically(add(meta_name), whole.dump(2) + "\n");
    for (const std::vector<std::string>& names : {older, names_})
        for (const std::string& name : names)
            for (const std::filesystem::path& input : inputs) {
                std::error_code ignored;
                if (std::filesystem::equivalent(folder_ / name, input, ignored))
                    throw file_error(fmt::format("{}: is read by this command and would be replaced; choose "
                                                 "another output path",
                                                 (folder_ / name).string()));
            }
    files_.appear(older);
}

}
