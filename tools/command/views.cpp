// SPDX-License-Identifier: MIT
#include "views.hpp"

#include "commands.hpp"
#include "progress.hpp"
#include "ranges.hpp"
#include "truth/kept_truth.hpp"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace crease::tools {

namespace {

/// The camera turned to the side, so that the middle of the picture moves by half a pixel.
camera half_a_pixel_on(camera from) {
    const glm::dvec3 ahead = from.target - from.eye;
    const glm::dvec3 side = glm::normalize(glm::cross(ahead, from.up));
    const double pixel = 2 * std::tan(glm::radians(double{from.vfov_deg}) / 2) / from.height;
    from.target += side * (glm::length(ahead) * pixel / 2);
    return from;
}

/// The truth of a view, traced once where a directory keeps it.
truth truth_of(const subject& view, const mesh& scene, const view_options& options) {
    const std::string label = fmt::format("{} {}", view.name, view.from.name);
    std::optional<progress> bar; // once it is traced
    const truth_settings settings{.width = options.width,
                                  .height = options.height,
                                  .radius = view.from.ao_radius,
                                  .rays = options.rays,
                                  .first_layer = options.hidden,
                                  .hull = options.hull,
                                  .progress = [&](double done) {
                                      if (!bar)
                                          bar.emplace("tracing " + label);
                                      (*bar)(done);
                                      return true;
                                  }};
    return options.truths.empty() ? trace_truth(scene, view.from, settings)
                                  : kept_truth(options.truths, label, scene, view.from, settings, note);
}

void add_views(vulkan::device& device, const std::string& path, const view_options& options,
               std::vector<subject>& views) {
    const mesh scene = scene_of(path, options.opacity, options.dynamic);
    check_hull(options.hull, scene);
    for (const camera& each : cameras_of(path, scene)) {
        if (!options.cameras.empty() && std::ranges::count(options.cameras, each.name) == 0)
            continue;
        camera from = options.lens.apply_to(each);
        from.width = options.width;
        from.height = options.height;
        subject view{.name = std::filesystem::path(path).stem().string(),
                     .from = from,
                     .inputs = rasterise(device, scene, from, options.guard, options.depth),
                     .traced = {},
                     .mask = {},
                     .moved = {}};
        if (options.moved)
            view.moved = rasterise(device, scene, half_a_pixel_on(from), options.guard, options.depth);
        check_sight(from, view.inputs.depth);
        view.traced = truth_of(view, scene, options);
        if (options.hidden)
            view.mask = hidden_mask(view.traced);
        views.push_back(std::move(view));
    }
}

}

void view_options::add_to(CLI::App& command) {
    command.add_option(
        "scenes", scenes,
        "scene files, with their cameras in <stem>.cameras.json, or built-in, or glass; else built-in");
    add_opacity_option(command, opacity);
    add_dynamic_option(command, dynamic);
    add_hull_option(command, hull);
    command.add_option("--guard", guard, "width of the guard band around the pictures, texels")
        ->check(whole_number_from(0, 4096));
    add_each(command, "--cameras", cameras, "name of a camera to use; else all");
    lens.add_to(command);
    add_depth_option(command, depth);
    command.add_option("--truths", truths, "directory that keeps the ray-traced truths between runs");
    command.add_option("--width", width, "texels")
        ->check(whole_number_from(1, longest_side))
        ->capture_default_str();
    command.add_option("--height", height, "texels")
        ->check(whole_number_from(1, longest_side))
        ->capture_default_str();
    command.add_option("--rays", rays, "of the truth")
        ->check(whole_number_from(1, 65536))
        ->capture_default_str();
}

void refuse_recipes_among(const std::vector<std::string>& scenes) {
    for (const std::string& scene : scenes)
        if (recipe(std::string_view(scene)))
            throw recipe_error(
                fmt::format("'{}' is a recipe and stands among the scenes; give each recipe by a "
                            "--recipes of its own",
                            scene));
}

std::vector<subject> load_subjects(vulkan::device& device, const view_options& options) {
    std::vector<subject> views;
    for (const std::string& scene :
         options.scenes.empty() ? std::vector<std::string>{"built-in"} : options.scenes)
        add_views(device, scene, options, views);
    for (const std::string& name : options.cameras)
        if (std::ranges::none_of(views, [&](const subject& view) { return view.from.name == name; }))
            throw std::runtime_error(fmt::format("none of the scenes has the camera '{}'", name));
    return views;
}

}
