// SPDX-License-Identifier: MIT
#pragma once

#include "image/image.hpp"
#include "scene/scene.hpp"

#include <crease/recipe.hpp>
#include <crease/vulkan.hpp>

#include <map>
#include <string>
#include <vector>

namespace crease::tools {

/// What the rasteriser makes of a scene: the inputs of an effect.
struct gbuffer {
    view_parameters view;      ///< the projection and the resolution
    std::vector<float> device; ///< device depth, 1 where there is background
    image depth;  ///< positive linear view depth; the camera's far plane where there is background
    image normal; ///< view space, unit, geometric, facing the camera; 0 where there is background
};

/// Rasterises the scene, both sides of every triangle, at the camera's width and height.
/// @throws vulkan::error
gbuffer rasterise(vulkan::device& device, const mesh& scene, const camera& from);

/// A picture of an effect.
struct frame {
    image visibility;
    std::vector<vulkan::pass_time> passes; ///< medians over the repeats
};

struct frame_options {
    float radius = 1;                      ///< world space, >= 0
    std::map<std::string, float> settings; ///< by the names that the effect's parts give them
    unsigned repeats = 1;                  ///< timed runs
};

/// Reads settings given as name=value.
/// @throws std::runtime_error  that quotes the one that does not read so
std::map<std::string, float> parse_settings(const std::vector<std::string>& texts);

/// Runs an effect on a G-buffer. The effect reads device depth and given or reconstructed normals.
/// @throws std::runtime_error  where a setting is unknown to every part of the recipe or out of its range;
///         vulkan::error
frame run_effect(vulkan::device& device, const recipe& chosen, const gbuffer& inputs,
                 const frame_options& options);

/// The parameters of a recipe with these settings, before the view.
/// @throws std::runtime_error  where a setting is unknown to every part of the recipe, or out of its range
parameters settle(const recipe& chosen, const frame_options& options);

}
