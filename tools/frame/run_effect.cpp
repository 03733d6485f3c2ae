// SPDX-License-Identifier: MIT
#include "frame/frame.hpp"

#include "frame/content.hpp"

#include "measure/median.hpp"

#include <crease/second_camera.hpp>

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <span>

namespace crease::tools {

namespace {

/// A fragment shader of the geometry, and the vertex shader before it.
struct capture_shaders {
    const char *vertex, *fragment;
};

constexpr capture_shaders positions{R"glsl(#version 450
layout(push_constant) uniform transforms {
    mat4 view_from_eye;
    mat4 clip_from_view;
};
layout(location = 0) in vec3 position;
layout(location = 0) out vec3 anchor;

void main() {
    anchor = position;
    gl_Position = clip_from_view * (view_from_eye * vec4(position, 1.0));
}
)glsl",
                                    R"glsl(
layout(location = 0) in vec3 anchor;

void main() { crease_capture(anchor); }
)glsl"};

constexpr capture_shaders surfaces{R"glsl(#version 450
layout(push_constant) uniform transforms {
    mat4 view_from_eye;
    mat4 clip_from_view;
};
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
layout(location = 0) out vec3 anchor;
layout(location = 1) flat out vec3 view_normal;
layout(location = 2) flat out vec4 surface_color;

void main() {
    anchor = position;
    view_normal = mat3(view_from_eye) * normal;
    surface_color = color;
    gl_Position = clip_from_view * (view_from_eye * vec4(position, 1.0));
}
)glsl",
                                   R"glsl(
layout(location = 0) in vec3 anchor;
layout(location = 1) flat in vec3 view_normal;
layout(location = 2) flat in vec4 surface_color;

void main() { crease_capture(anchor, view_normal, surface_color); }
)glsl"};

void upload_inputs(vulkan::runner& runner, const effect_view& effect, const gbuffer& inputs) {
    for (const resource& wanted : effect.resources)
        if (wanted.life == lifetime::input && wanted.kind == resource_kind::image)
            runner.upload(wanted.name, content_of(wanted, inputs));
}

/// What an effect must know of the camera beside its projection.
void describe_camera(parameters& how, const effect_view& effect, const gbuffer& inputs) {
    const glm::mat4 to_view(glm::dmat4(view_rotation(inputs.from)));
    set_world_to_view(how, effect.settings, glm::value_ptr(to_view));
    set(how, effect.settings, "logarithmic_depth.far", far_plane(inputs));
}

/// The places of the further cameras: on both sides of the first, turned to the middle of what it sees, and
/// half way there; of the second that of the options, if there is one.
void place_further(parameters& how, const gbuffer& inputs, const frame_options& options) {
    const double unit = inputs.drawn.scale.unit;
    std::vector<float> seen;
    for (std::size_t i = 0; i < inputs.depth.texels.size(); ++i)
        if (inputs.depth.texels[i] < inputs.from.far)
            seen.push_back(static_cast<float>(inputs.depth.texels[i] / unit));
    const float middle = seen.empty() ? 1 : median(seen);
    place_further_camera(how.further_views[0], middle / 4, middle / 4, middle);
    place_further_camera(how.further_views[1], -middle / 4, middle / 4, middle);
    place_further_camera(how.further_views[2], 0, middle / 2, middle);
    if (options.second) {
        const glm::dmat3 rotation = view_rotation(*options.second);
        glm::dmat4 turn(rotation * glm::transpose(view_rotation(inputs.from)));
        turn[3] = glm::dvec4(rotation * ((inputs.from.eye - options.second->eye) / unit), 1);
        const glm::mat4 rounded(turn);
        std::copy_n(glm::value_ptr(rounded), 16, how.further_views[0].from_first);
    }
}

/// A recipe with one part more.
recipe with(const recipe& before, const part& added) {
    std::vector<const part*> known = {&added}; // of the others some may be a host's own
    for (const choice& c : before.choices())
        known.push_back(c.what);
    return recipe(std::string(before.text().view()) + "/" + std::string(added.name), known);
}

/// The unit direction that a point of the octahedron stands for.
glm::vec3 of_octahedron(glm::vec2 point) {
    glm::vec3 direction(point, 1 - std::abs(point.x) - std::abs(point.y));
    const float outside = std::max(-direction.z, 0.0f);
    direction.x -= std::copysign(outside, direction.x);
    direction.y -= std::copysign(outside, direction.y);
    return glm::normalize(direction);
}

/// How the camera of a geometry pass draws: of a further one at the size of what it fills.
transforms transforms_of(const pass& which, parameters& how, const gbuffer& inputs) {
    if (which.view == 0)
        return inputs.drawn.how;
    // The same lens as the first camera's, without its guard band.
    const unsigned width = which.size.width_of(inputs.depth.width),
                   height = which.size.height_of(inputs.depth.height);
    const float guard_across =
        1 + 2 * static_cast<float>(inputs.guard) / static_cast<float>(inputs.depth.width);
    const float guard_down =
        1 + 2 * static_cast<float>(inputs.guard) / static_cast<float>(inputs.depth.height);
    glm::mat4 projection = inputs.drawn.how.clip_from_view;
    for (int column = 0; column < 4; ++column) {
        projection[column][0] *= guard_across;
        projection[column][1] *= guard_down;
    }
    further_view& further = how.further_views[which.view - 1];
    further.view = view_of(projection, width, height);
    glm::mat4 turn;
    std::copy_n(further.from_first, 16, glm::value_ptr(turn));
    return {turn * inputs.drawn.how.view_from_eye, projection};
}

/// What a geometry pass draws of a scene.
const vulkan::mesh& drawn_in(const pass& which, const geometry& scene) {
    if (draws_dynamic(which))
        return *scene.of_dynamic;
    return which.name.starts_with("capture_static") ? *scene.of_static : *scene.triangles;
}

}

bool draws_dynamic(const pass& which) {
    return which.name.starts_with("capture_dynamic");
}

recipe seen_by(const camera& from, const recipe& chosen) {
    const part& suits = from.orthographic ? orthographic::description : perspective::description;
    for (const choice& c : chosen.choices())
        if (c.what->kind == role::projection && c.what->name != suits.name)
            throw recipe_error(fmt::format("the recipe has the projection '{}', and the camera '{}' is {}",
                                           c.what->name, from.name, suits.name));
    const choice_list all = complete(chosen.choices());
    return std::ranges::any_of(all, [&](const choice& c) { return c.what->name == suits.name; })
               ? chosen
               : with(chosen, suits);
}

recipe supported(const vulkan::device& device, const recipe& chosen) {
    const auto features = [](const recipe& of) { return std::make_unique<composition>(of)->view().features; };
    const auto has = [](array_view<const choice> parts, role wanted) {
        return std::ranges::any_of(parts, [wanted](const choice& c) { return c.what->kind == wanted; });
    };
    recipe suited = chosen;
    if (device.is_processor() && !has(chosen.choices(), role::image_reads))
        suited = with(suited, image_load::description);
    if (device.is_processor() && !has(chosen.choices(), role::stage))
        suited = with(suited, compute_columns_part::description);
    const choice_list parts = complete(chosen.choices());
    if (!has(parts, role::layer_storage) || has(chosen.choices(), role::layer_storage))
        return suited;
    for (const part* storage : all_parts) {
        if (storage->kind != role::layer_storage)
            continue;
        const recipe stored = with(suited, *storage);
        if (stored && device.features().cover(features(stored)))
            return stored;
    }
    return suited; // whose features the runner names
}

prepared_effect::prepared_effect(vulkan::device& device, const recipe& wanted, const gbuffer& inputs,
                                 const frame_options& options)
    : inputs_(inputs) {
    const recipe chosen = supported(device, seen_by(inputs.from, wanted));
    if (!chosen)
        throw recipe_error(std::string(chosen.error()));
    how_ = settle(chosen, options);
    composed_ = std::make_unique<composition>(chosen);
    const effect_view effect = composed_->view();
    if (!*composed_)
        throw recipe_error(std::string(composed_->error()));
    if (effect.passes.back().stage == stage_kind::functions ||
        effect.passes.back().dialect != dialect_kind::vulkan)
        throw recipe_error("a recipe that is run is of programs in the vulkan dialect");
    if (std::ranges::any_of(effect.passes, draws_dynamic) && !inputs.drawn.of_dynamic)
        throw recipe_error("the recipe draws dynamic geometry apart from static geometry, and nothing of the "
                           "scene is dynamic; name nodes or groups of it by --dynamic, or take "
                           "separated_layers");
    how_.view = inputs.view;
    how_.radius = inputs.drawn.scale.radius(options.radius);
    describe_camera(how_, effect, inputs);
    if (effect.views > 1)
        place_further(how_, inputs, options);
    runner_ = std::make_unique<vulkan::runner>(
        device, effect, inputs.depth.width, inputs.depth.height,
        vulkan::runner_options{.guard = inputs.guard, .constants = {}, .shaders = {}});
    upload_inputs(*runner_, effect, inputs);
    set_geometry();
}

void prepared_effect::set_geometry() {
    for (const pass& each : composed_->view().passes) {
        if (each.stage != stage_kind::geometry)
            continue;
        const capture_shaders& shaders = each.takes_surfaces ? surfaces : positions;
        const piece vertex[] = {{"capture.vert", shaders.vertex}},
                    fragment[] = {{"capture.frag", shaders.fragment}};
        const transforms pushed = transforms_of(each, how_, inputs_);
        runner_->set_geometry(each.name,
                              {.vertex = vertex,
                               .fragment = fragment,
                               .push_constant_bytes = sizeof pushed,
                               .reversed_depth = inputs_.depth_kind != device_depth_kind::standard},
                              drawn_in(each, inputs_.drawn), std::as_bytes(std::span(&pushed, 1)));
    }
}

frame_times prepared_effect::run() {
    frame_times times;
    const array_view<const pass> passes = composed_->view().passes;
    const std::vector<vulkan::pass_time> all = runner_->run(how_);
    for (std::size_t i = 0; i < all.size(); ++i)
        (passes[i].stage == stage_kind::geometry ? times.captures : times.passes).push_back(all[i]);
    return times;
}

frame prepared_effect::picture() {
    const unsigned width = inputs_.depth.width, height = inputs_.depth.height;
    frame made{.visibility = image(width, height), .bent = {}, .cone = {}, .colour = {}, .times = {}};
    for (const resource& r : composed_->view().resources) {
        if (r.name == "visibility")
            made.visibility.texels = runner_->download(r.name);
        if (r.name == "color") {
            made.colour = image(width, height, 4);
            made.colour->texels = runner_->download(r.name);
        }
        const bool packed = r.name == "packed_bent_cone";
        if (!packed && r.name != "bent_cone")
            continue;
        made.bent = image(width, height, 3);
        made.cone = image(width, height);
        const std::vector<float> four = runner_->download(r.name);
        for (std::size_t i = 0; i < made.cone->texels.size(); ++i) {
            const glm::vec4 texel = glm::make_vec4(&four[4 * i]);
            const glm::vec4 bent_cone = packed ? glm::vec4(of_octahedron(glm::vec2(texel) * 2.0f - 1.0f),
                                                           texel.z * glm::half_pi<float>())
                                               : texel;
            std::copy_n(glm::value_ptr(bent_cone), 3, &made.bent->texels[3 * i]);
            made.cone->texels[i] = bent_cone.w;
            if (packed)
                made.visibility.texels[i] = texel.w;
        }
    }
    return made;
}

std::vector<reported_count> prepared_effect::reports() const {
    std::vector<reported_count> all;
    for (const resource& r : composed_->view().resources) {
        if (r.meaning.empty())
            continue;
        std::uint32_t count = 0;
        std::memcpy(&count, runner_->download_buffer(r.name).data(), sizeof count);
        if (count > 0)
            all.push_back({count, std::string(r.meaning)});
    }
    return all;
}

frame run_effect(vulkan::device& device, const recipe& chosen, const gbuffer& inputs,
                 const frame_options& options) {
    prepared_effect ready(device, chosen, inputs, options);
    const frame_times times = ready.run();
    frame made = ready.picture();
    made.times = times;
    return made;
}

}
