// SPDX-License-Identifier: MIT
#pragma once

#include "frame/frame.hpp"
#include "measure/compare.hpp"
#include "scene_options.hpp"
#include "truth/truth.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace crease::tools {

/// The arguments that choose the views over which recipes are measured, and what is known of these.
struct view_options {
    std::vector<std::string> scenes{}, cameras{};
    lens_options lens{};
    device_depth_kind depth = device_depth_kind::reversed;
    std::optional<float> opacity{};     ///< of surfaces that are opaque otherwise
    std::vector<std::string> dynamic{}; ///< names of what moves in each scene
    bool hull = false;                  ///< transparent surfaces are thin hulls to the truth
    unsigned guard = 0, width = 1280, height = 720, rays = 256;
    std::filesystem::path truths{}; ///< a directory that keeps them; empty: none does
    bool hidden = false;            ///< where occluders hide is known too
    bool moved = false;             ///< and what the camera sees after it turned

    void add_to(CLI::App& command);
};

/// A view of a scene with its inputs and its truth.
struct subject {
    std::string name;
    camera from;
    gbuffer inputs;
    truth traced;
    image mask;    ///< where hidden geometry takes much of the visibility; empty where nobody asked
    gbuffer moved; ///< after the camera turned by half a pixel; empty where nobody asked

    /// What is compared: not the background.
    comparison_settings mask_of_background() const { return {.depth = &inputs.depth, .far = from.far}; }
};

/// @throws recipe_error where a recipe stands among scenes, as where it is named behind another's option
void refuse_recipes_among(const std::vector<std::string>& scenes);

/// The views of all scenes, in their order; of the built-in scene where none is named.
/// @throws as rasterise, trace_truth and kept_truth do
std::vector<subject> load_subjects(vulkan::device& device, const view_options& options);

}
