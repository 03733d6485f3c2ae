// SPDX-License-Identifier: MIT
#pragma once

#include "frame/geometry.hpp"
#include "image/image.hpp"
#include "scene/scene.hpp"

#include <crease/recipe.hpp>
#include <crease/vulkan.hpp>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace crease::tools {

/// What the rasteriser makes of a scene: the inputs of an effect, and the geometry for what else it captures.
struct gbuffer {
    camera from;
    view_parameters view; ///< the projection, the resolution and the guard band, in the unit of what is drawn
    unsigned guard = 0;   ///< width of the guard band, texels
    geometry drawn;
    std::vector<float> device;  ///< reversed device depth, guard band included; 0 where there is background
    std::vector<float> normals; ///< four a texel, guard band included: view space, unit, geometric, facing
                                ///< the camera; 0 where there is background
    image depth;  ///< of the picture: positive linear view depth, world units; the camera's far plane where
                  ///< there is background
    image normal; ///< of the picture: the normals, 3 channels
};

/// Rasterises the scene, both sides of every triangle, at the camera's width and height and a guard band
/// around.
/// @throws vulkan::error, scene_error
gbuffer rasterise(vulkan::device& device, const mesh& scene, const camera& from, unsigned guard = 0);

/// What a picture of an effect took.
struct frame_times {
    std::vector<vulkan::pass_time> captures, passes;
};

/// A picture of an effect.
struct frame {
    image visibility;
    std::optional<image> bent, cone; ///< where the effect has that output: 3 channels, view space; radians
    frame_times times;               ///< medians over the repeats
};

struct frame_options {
    float radius = 1;                      ///< world space, >= 0
    std::map<std::string, float> settings; ///< by the names that the effect's parts give them
    std::uint32_t frame = 0;               ///< index that changes the randomness
    std::optional<camera> second = {};     ///< of an effect with a second view; else placed beside the first
};

/// Reads settings given as name=value.
/// @throws std::runtime_error  that quotes the one that does not read so
std::map<std::string, float> parse_settings(const std::vector<std::string>& texts);

/// The recipe with the first layer carrier, in the order of the index of parts, that the device supports,
/// where it captures layers and names none.
/// @throws vulkan::error  where the device supports none
recipe supported(const vulkan::device& device, const recipe& chosen);

/// An effect that is ready to run on a G-buffer, which must outlive it. The effect reads device depth and
/// given or reconstructed normals.
class prepared_effect {
public:
    /// @throws std::runtime_error  where a setting is unknown to every part of the recipe or out of its
    /// range;
    ///         vulkan::error
    prepared_effect(vulkan::device& device, const recipe& chosen, const gbuffer& inputs,
                    const frame_options& options);

    /// Draws the captures and runs the passes.
    frame_times run();

    /// What the last run made, without times.
    frame picture();

private:
    struct prepared_capture {
        std::unique_ptr<vulkan::capturer> draws;
        transforms pushed;
    };

    const gbuffer& inputs_;
    std::unique_ptr<composition> composed_;
    parameters how_;
    std::unique_ptr<vulkan::runner> runner_;
    std::vector<prepared_capture> captures_;

    void prepare_captures(vulkan::device& device);
};

/// Runs effects on a G-buffer by turns, so that a machine whose speed drifts slows all of them alike.
/// @param repeats  how often each runs; one run more, which compiles, is left out
/// @return for each effect the medians
std::vector<frame_times> take_turns(std::span<const std::unique_ptr<prepared_effect>> effects,
                                    unsigned repeats, const std::function<void(double)>& progress = {});

/// Runs an effect on a G-buffer once.
/// @throws as prepared_effect does
frame run_effect(vulkan::device& device, const recipe& chosen, const gbuffer& inputs,
                 const frame_options& options);

/// The parameters of a recipe with these settings, before the view.
/// @throws std::runtime_error  where a setting is unknown to every part of the recipe, or out of its range
parameters settle(const recipe& chosen, const frame_options& options);

}
