// SPDX-License-Identifier: MIT
#include "scene_options.hpp"

#include "commands.hpp"
#include "ranges.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace crease::tools {

namespace {

/// A scene that needs no file.
struct built_in {
    const char* name;
    mesh (*scene)();
    std::vector<camera> (*cameras)();
};

const built_in* find_built_in(const std::string& name) {
    static constexpr built_in all[] = {{"built-in", &built_in_scene, &built_in_cameras},
                                       {"glass", &glass_scene, &glass_cameras}};
    const auto found = std::ranges::find(all, name, &built_in::name);
    return found == std::end(all) ? nullptr : found;
}

}

void note(const std::string& sentence) {
    fmt::print(stderr, "crease: {}\n", sentence);
}

void lens_options::add_to(CLI::App& command) {
    command.add_flag("--orthographic", orthographic,
                     "parallel rays, with the picture as high as the field of view is at the target");
    command
        .add_option("--shift", shift,
                    "moves the picture off its axis, by X of its widths to the right and Y of its heights up")
        ->type_name("X Y")
        ->check(number_from(-10, 10));
}

camera lens_options::apply_to(tools::camera from) const {
    from.orthographic = orthographic;
    from.shift = {shift.first, shift.second};
    return from;
}

void add_depth_option(CLI::App& command, device_depth_kind& depth) {
    command
        .add_option_function<std::string>(
            "--depth",
            [&depth](const std::string& name) {
                for (const auto kind :
                     {device_depth_kind::reversed, device_depth_kind::standard, device_depth_kind::infinite})
                    if (name == name_of(kind))
                        depth = kind;
            },
            "of the G-buffer: reversed (1 at near, 0 at far), standard (0 at near, 1 at far) or infinite "
            "(reversed, without a far plane); else reversed")
        ->check(CLI::IsMember({"reversed", "standard", "infinite"}));
}

mesh scene_of(const std::string& name, std::optional<float> opacity, std::span<const std::string> dynamic) {
    const built_in* known = find_built_in(name);
    const mesh scene = with_dynamic(known ? known->scene() : load_mesh(name), dynamic, name + ": --dynamic");
    return opacity ? with_opacity(scene, *opacity) : scene;
}

void add_dynamic_option(CLI::App& command, std::vector<std::string>& dynamic) {
    add_each(
        command, "--dynamic", dynamic,
        "name of a node of the scene, and all below it, or of an object or a group, that moves; those that "
        "glTF gives an animation or a skin do");
}

void add_opacity_option(CLI::App& command, std::optional<float>& opacity) {
    command.add_option("--opacity", opacity, "of every surface that is opaque otherwise, above 0")
        ->check(number_from(0.001, 1));
}

void add_hull_option(CLI::App& command, bool& hull) {
    command.add_flag("--hull", hull,
                     "the truth takes transparent surfaces for thin hulls, of which both sides are occluded");
}

void check_hull(bool hull, const mesh& scene) {
    if (hull && !is_transparent(scene))
        throw scene_error("--hull: the scene has no transparent surface; leave it out, or use --opacity");
}

std::filesystem::path cameras_beside(const std::string& scene_name) {
    return std::filesystem::path(scene_name).replace_extension(".cameras.json");
}

std::vector<camera> cameras_of(const std::string& scene_name, const mesh& scene,
                               const std::filesystem::path& file) {
    if (!file.empty())
        return load_cameras(file);
    if (const built_in* known = find_built_in(scene_name))
        return known->cameras();
    const std::filesystem::path beside = cameras_beside(scene_name);
    if (std::filesystem::exists(beside))
        return load_cameras(beside);
    const camera fitted = fitted_camera(scene);
    note(fmt::format(
        "there is no {}; a camera is fitted to the scene: eye {:.3g} {:.3g} {:.3g}, target {:.3g} "
        "{:.3g} {:.3g}, radius {:.3g}",
        beside.string(), fitted.eye.x, fitted.eye.y, fitted.eye.z, fitted.target.x, fitted.target.y,
        fitted.target.z, fitted.ao_radius));
    return {fitted};
}

void check_sight(const camera& from, const image& depth) {
    if (std::ranges::all_of(depth.texels, [&](float z) { return z >= from.far; }))
        throw scene_error(
            fmt::format("the camera '{}' sees nothing of the scene between near, {:.3g}, and far, "
                        "{:.3g}; turn it to the scene, or change them",
                        from.name, from.near, from.far));
}

void scene_options::add_to(CLI::App& command) {
    command.add_option("scene", scene, "a .glb, .gltf or .obj file, or built-in, or glass")->required();
    command.add_option("--cameras", cameras,
                       "JSON list of cameras; else <stem>.cameras.json beside the scene, or a camera that is "
                       "fitted to it");
    command.add_option("--camera", camera, "name of one of them; else the first");
    command.add_option("--width", width, "texels; else the camera's")
        ->check(whole_number_from(1, longest_side));
    command.add_option("--height", height, "texels; else the camera's")
        ->check(whole_number_from(1, longest_side));
    command.add_option("--radius", radius, "world-space AO radius; else the camera's")
        ->check(number_from(0, farthest_coordinate));
    add_opacity_option(command, opacity);
    lens.add_to(command);
}

camera scene_options::choose(const std::vector<tools::camera>& all) const {
    tools::camera chosen = lens.apply_to(camera.empty() ? all.front() : find_camera(all, camera));
    chosen.width = width.value_or(chosen.width);
    chosen.height = height.value_or(chosen.height);
    chosen.ao_radius = radius.value_or(chosen.ao_radius);
    return chosen;
}

nlohmann::ordered_json described(const scene_options& options, const camera& from) {
    nlohmann::ordered_json all{{"scene", options.scene},
                               {"camera", from.name},
                               {"width", from.width},
                               {"height", from.height},
                               {"near", from.near},
                               {"far", from.far},
                               {"projection", from.orthographic ? "orthographic" : "perspective"},
                               {"shift", {from.shift.x, from.shift.y}},
                               {"radius", from.ao_radius}};
    if (options.opacity)
        all["opacity"] = *options.opacity;
    return all;
}

}
