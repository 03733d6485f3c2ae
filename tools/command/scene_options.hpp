// SPDX-License-Identifier: MIT
#pragma once

#include "frame/geometry.hpp"
#include "image/image.hpp"
#include "scene/scene.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace crease::tools {

/// Says a line on stderr that is no failure.
void note(const std::string& sentence);

/// What a camera's picture is like beside what the camera itself says.
struct lens_options {
    bool orthographic = false;
    std::pair<double, double> shift{0, 0};

    void add_to(CLI::App& command);
    tools::camera apply_to(tools::camera from) const;
};

/// The option of the device depth that a G-buffer has.
void add_depth_option(CLI::App& command, device_depth_kind& depth);

/// The triangles of a file, or of a built-in scene.
/// @param opacity  for each surface that is opaque otherwise
/// @param dynamic  names of triangles that are dynamic, beside those that the file says
mesh scene_of(const std::string& name, std::optional<float> opacity = {},
              std::span<const std::string> dynamic = {});

/// Adds the option of those names.
void add_dynamic_option(CLI::App& command, std::vector<std::string>& dynamic);

/// Adds the option of that opacity.
void add_opacity_option(CLI::App& command, std::optional<float>& opacity);

/// Adds the flag that makes thin hulls of transparent surfaces for the truth.
void add_hull_option(CLI::App& command, bool& hull);

/// @throws scene_error where hulls are asked for and nothing is transparent
void check_hull(bool hull, const mesh& scene);

/// Where the cameras of a scene are looked for: <stem>.cameras.json beside it.
std::filesystem::path cameras_beside(const std::string& scene_name);

/// The cameras of `file` where there is one; else those of a built-in scene, or of the file beside the
/// scene; else one that is fitted to it, which a line on stderr says.
std::vector<camera> cameras_of(const std::string& scene_name, const mesh& scene,
                               const std::filesystem::path& file = {});

/// @param depth  what the camera sees
/// @throws scene_error where that is background alone
void check_sight(const camera& from, const image& depth);

/// The arguments that choose a view of a scene.
struct scene_options {
    std::string scene; ///< a path, or the name of a built-in scene
    std::filesystem::path cameras;
    std::string camera;
    std::optional<unsigned> width, height;
    std::optional<float> radius, opacity;
    lens_options lens;

    void add_to(CLI::App& command);

    /// The camera of --camera, or the first, with what the options change of it.
    tools::camera choose(const std::vector<tools::camera>& all) const;

    /// The files that are read.
    std::vector<std::filesystem::path> inputs() const {
        return {scene, cameras.empty() ? cameras_beside(scene) : cameras};
    }
};

/// What meta.json says of a view.
nlohmann::ordered_json described(const scene_options& options, const camera& from);

}
