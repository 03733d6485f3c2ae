// SPDX-License-Identifier: MIT
#pragma once

#include "frame/geometry.hpp"
#include "image/image.hpp"
#include "recipe_error.hpp"
#include "scene/scene.hpp"

#include <crease/compose/composition.hpp>
#include <crease/vulkan.hpp>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace crease::tools {

/// What the rasteriser makes of a scene: the inputs of an effect, and the geometry for what else it captures.
struct gbuffer {
    camera from;
    view_parameters view; ///< the projection, the resolution and the guard band, in the unit of what is drawn
    unsigned guard = 0;   ///< width of the guard band, texels
    geometry drawn;
    device_depth_kind depth_kind = device_depth_kind::reversed;
    std::vector<float> device;  ///< device depth, guard band included
    std::vector<float> normals; ///< four a texel, guard band included: view space, unit, geometric, facing
                                ///< the camera; 0 where there is background
    image depth;  ///< of the picture: positive linear view depth, world units; the camera's far plane where
                  ///< there is background
    image normal; ///< of the picture: the normals, 3 channels
};

/// Rasterises the scene, both sides of every triangle and as if all were opaque, at the camera's width and
/// height and a guard band around.
/// @throws vulkan::error, scene_error
gbuffer rasterise(vulkan::device& device, const mesh& scene, const camera& from, unsigned guard = 0,
                  device_depth_kind depth = device_depth_kind::reversed);

/// Linear view depth in the unit of what is drawn.
float linear_depth_of(const gbuffer& inputs, float device);

/// What a picture of an effect took: its geometry passes, and the others.
struct frame_times {
    std::vector<vulkan::pass_time> captures, passes;

    double total() const; ///< milliseconds
};

/// A picture of an effect.
struct frame {
    image visibility;
    std::optional<image> bent, cone; ///< where the effect has that output: 3 channels, view space; radians
    std::optional<image> colour;     ///< likewise: linear RGB times the opacity, and the opacity
    frame_times times;               ///< medians over the repeats
};

/// A counter that an effect reports, and that is not 0.
struct reported_count {
    std::uint32_t count;
    std::string meaning; ///< of what, and what to do about it
};

struct frame_options {
    float radius = 1;                      ///< world space, >= 0
    std::map<std::string, float> settings; ///< by the names that the effect's parts give them, "bias" or
                                           ///< "hbao.bias"
    std::uint32_t frame = 0;               ///< index that changes the randomness
    std::optional<camera> second = {};     ///< of an effect with a second view; else placed beside the first
};

/// @throws recipe_error  with the sentence of the refusal
recipe parse_recipe(std::string_view text);

/// Reads settings given as name=value.
/// @throws recipe_error  that quotes the one that does not read so
std::map<std::string, float> parse_settings(const std::vector<std::string>& texts);

/// The recipe with the projection of a camera, where it names none.
/// @throws recipe_error  where it names another
recipe seen_by(const camera& from, const recipe& chosen);

/// The recipe with what suits the device, where it names none: the first layer storage, in the order of the
/// index of parts, that the device supports, where it captures layers; on a processor reads by image loads,
/// and workgroups in columns.
recipe supported(const vulkan::device& device, const recipe& chosen);

/// Whether a geometry pass draws dynamic triangles alone.
bool draws_dynamic(const pass& which);

/// An effect that is ready to run on a G-buffer, which must outlive it. The effect reads device depth and
/// given or reconstructed normals.
class prepared_effect {
public:
    /// @throws recipe_error  where the recipe cannot be run, does not fit the camera or draws dynamic
    /// triangles
    ///                       of a scene without any, or a setting is unknown to every part of it or out of
    ///                       its range;
    ///         vulkan::error, scene_error
    prepared_effect(vulkan::device& device, const recipe& chosen, const gbuffer& inputs,
                    const frame_options& options);

    /// Runs the passes, those that draw geometry among them.
    frame_times run();

    /// What the last run made, without times.
    frame picture();

    /// What the last run counted that should not be.
    std::vector<reported_count> reports() const;

private:
    const gbuffer& inputs_;
    std::unique_ptr<composition> composed_;
    parameters how_;
    std::unique_ptr<vulkan::runner> runner_;

    void set_geometry();
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

/// How a user names a setting: with its part, "hbao.bias", unless parts share it.
std::string name_of(const effect_setting& s);

/// The settings of a recipe's parts, in the order of its block of parameters.
std::vector<effect_setting> settings_of(const recipe& chosen);

/// The parameters of a recipe with these settings, before the view.
/// @throws recipe_error  where a setting is unknown to every part of the recipe, or out of its range
parameters settle(const recipe& chosen, const frame_options& options);

}
