// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace crease::tools {

/// The arguments that choose a view of a scene.
struct scene_options {
    std::string scene; ///< a path, or "built-in"
    std::filesystem::path cameras;
    std::string camera;
    std::optional<unsigned> width, height;
    std::optional<float> radius;

    mesh load() const { return scene == "built-in" ? built_in_scene() : load_mesh(scene); }

    /// The cameras of --cameras; the built-in scene brings its own.
    std::vector<tools::camera> load_all_cameras() const {
        if (!cameras.empty())
            return load_cameras(cameras);
        if (scene == "built-in")
            return built_in_cameras();
        throw scene_error("--cameras is missing: a JSON list of cameras for '" + scene + "'");
    }

    /// The camera of --camera, or the first, with the sizes and the radius that override its own.
    tools::camera load_camera() const {
        const std::vector<tools::camera> all = load_all_cameras();
        if (all.empty())
            throw scene_error("'" + cameras.string() + "' lists no camera");
        tools::camera chosen = camera.empty() ? all.front() : find_camera(all, camera);
        chosen.width = width.value_or(chosen.width);
        chosen.height = height.value_or(chosen.height);
        chosen.ao_radius = radius.value_or(chosen.ao_radius);
        return chosen;
    }

    void add_to(CLI::App& command) {
        command.add_option("scene", scene, "a .glb, .gltf or .obj file, or built-in")->required();
        command.add_option("--cameras", cameras, "JSON list of cameras");
        command.add_option("--camera", camera, "name of one of them; else the first");
        command.add_option("--width", width, "texels; else the camera's")->check(CLI::Range(1u, 16384u));
        command.add_option("--height", height, "texels; else the camera's")->check(CLI::Range(1u, 16384u));
        command.add_option("--radius", radius, "world-space AO radius; else the camera's")
            ->check(CLI::NonNegativeNumber);
    }
};

}
