// SPDX-License-Identifier: MIT
#pragma once

#include "image/image.hpp"
#include "temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

/// What a run of the command ended with.
struct ended {
    int status = 0;
    std::string said, complained; ///< on stdout and stderr
};

/// Runs the command.
/// @param arguments  as a shell takes them
ended crease_command(const std::string& arguments);

/// Runs it and expects success.
/// @return what it said
std::string expect_success(const std::string& arguments);

/// The names of the files below a folder, relative to it.
std::set<std::string> files_in(const std::filesystem::path& folder);

nlohmann::json json_in(const std::filesystem::path& file);

/// The pictures of 64 x 36 that a run of the command wrote to a folder of its own.
struct written_pictures {
    temporary_folder folder;

    /// @param arguments  but for the folder
    explicit written_pictures(const std::string& arguments);
    crease::tools::image operator[](const std::string& file) const;
};

/// One channel of an EXR file, row 0 first.
std::vector<float> exr_channel_of(const std::filesystem::path& file, const std::string& name);

/// The bytes of a PNG, row 0 first.
std::vector<unsigned char> png_of(const std::filesystem::path& file);

/// Every `channels`th number, from `first` on.
std::vector<float> channel(const crease::tools::image& of, unsigned first);

/// A scene with its camera in files of a folder. The camera looks down on the ground at y = 0 from a height
/// of 4, to the right along x, and is 64 x 36.
class scene_files {
public:
    /// @param wall  whether a wall stands on the ground at x = 0, to the left of the middle
    explicit scene_files(bool wall);

    /// The scene's file, in quotes; its cameras are beside it.
    std::string scene() const;

    /// The arguments of a command that takes a scene.
    std::string arguments() const;

    static constexpr double height = 4, radius = 2;

    /// Where on the ground the centre of a column is.
    static double x_of(unsigned column);

private:
    temporary_folder folder_;
};
