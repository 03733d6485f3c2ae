// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "frame/frame.hpp"
#include "ranges.hpp"
#include "result_files.hpp"
#include "scene_options.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

namespace crease::tools {

namespace {

struct render_options {
    scene_options scene;
    std::string recipe, device, second_camera;
    unsigned guard = 0;
    std::uint32_t frame = 0;
    std::vector<std::string> settings, dynamic;
    device_depth_kind depth = device_depth_kind::reversed;
    bool validation = false;
    std::filesystem::path directory;
};

constexpr unsigned timed_runs = 5;

image scaled(image values, float by, float and_add) {
    for (float& v : values.texels)
        v = v * by + and_add;
    return values;
}

/// Colours that are multiplied by their opacity, over white.
image over_white(const image& colours) {
    image whole(colours.width, colours.height, 3);
    for (std::size_t i = 0; i < whole.texels.size(); ++i)
        whole.texels[i] = colours.texels[i / 3 * 4 + i % 3] + 1 - colours.texels[i / 3 * 4 + 3];
    return whole;
}

/// As screens show linear colours (IEC 61966-2-1).
image srgb(image colours) {
    for (float& v : colours.texels)
        v = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
    return colours;
}

nlohmann::ordered_json times_of(const std::vector<vulkan::pass_time>& times) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const vulkan::pass_time& t : times)
        all.push_back({{"name", t.pass}, {"milliseconds", t.milliseconds}});
    return all;
}

nlohmann::ordered_json describe(const render_options& options, const camera& from, const recipe& chosen,
                                const parameters& used, const frame_times& times, const std::string& device) {
    nlohmann::ordered_json settings;
    const std::vector<effect_setting> known = settings_of(chosen);
    for (std::size_t i = 0; i < known.size(); ++i)
        settings[name_of(known[i])] = used.settings[i];
    nlohmann::ordered_json meta = described(options.scene, from);
    meta.update({{"recipe", std::string(chosen.text().view())},
                 {"settings", settings},
                 {"device", device},
                 {"depth", name_of(options.depth)},
                 {"guard", options.guard},
                 {"frame", options.frame},
                 {"measured", fmt::format("of each pass, the geometry passes of the effect (captures) among "
                                          "them, the median time on the device of {} runs, after runs that "
                                          "compile; without the G-buffer",
                                          timed_runs)},
                 {"captures", times_of(times.captures)},
                 {"passes", times_of(times.passes)}});
    if (!options.dynamic.empty())
        meta["dynamic"] = options.dynamic;
    return meta;
}

/// Refuses options that a recipe has no use for.
void check_use(const render_options& options, const recipe& chosen) {
    const auto composed = std::make_unique<composition>(chosen);
    const effect_view effect = composed->view();
    if (!options.second_camera.empty() && effect.views < 2)
        throw recipe_error("--second-camera: the recipe has no second view; add /second_view to it");
    const bool has_noise = std::ranges::any_of(effect.passes, [](const pass& p) {
        return std::ranges::any_of(p.pieces, [](const piece& text) {
            return text.text.find("crease_frame") != std::string_view::npos;
        });
    });
    if (options.scene.opacity &&
        std::ranges::none_of(effect.passes, [](const pass& p) { return p.takes_surfaces; }))
        throw recipe_error("--opacity: the recipe takes every surface for opaque; add /every_layer to it");
    if (!options.dynamic.empty() && std::ranges::none_of(effect.passes, draws_dynamic))
        throw recipe_error("--dynamic: the recipe draws all geometry alike; take static_and_dynamic_layers");
    if (options.frame != 0 && !has_noise)
        throw recipe_error("--frame: the recipe has no randomness that it could change");
}

void run(const render_options& options) {
    const recipe wanted = parse_recipe(options.recipe);
    check_use(options, wanted);
    frame_options how{.radius = options.scene.radius.value_or(1),
                      .settings = parse_settings(options.settings),
                      .frame = options.frame};
    settle(wanted, how);
    const mesh scene = scene_of(options.scene.scene, options.scene.opacity, options.dynamic);
    const std::vector<camera> cameras = cameras_of(options.scene.scene, scene, options.scene.cameras);
    const camera from = options.scene.choose(cameras);
    how.radius = from.ao_radius;
    if (!options.second_camera.empty())
        how.second = find_camera(cameras, options.second_camera);
    vulkan::device device({.name = options.device, .validation = options.validation});
    const recipe chosen = supported(device, seen_by(from, wanted));
    const gbuffer inputs = rasterise(device, scene, from, options.guard, options.depth);
    const std::unique_ptr<prepared_effect> effect[] = {
        std::make_unique<prepared_effect>(device, chosen, inputs, how)};
    check_sight(from, inputs.depth);
    effect[0]->run();
    const frame made = effect[0]->picture(); // before timed runs fill histories
    for (const reported_count& each : effect[0]->reports())
        fmt::print(stderr, "crease: warning: {} {}\n", each.count, each.meaning);
    const frame_times times = take_turns(effect, timed_runs)[0];
    result_files files(options.directory);
    write_pfm(files.add("ao.pfm"), made.visibility);
    write_png(files.add("ao.png"), made.visibility);
    if (made.bent) {
        write_pfm(files.add("bent.pfm"), *made.bent);
        write_pfm(files.add("cone.pfm"), *made.cone);
        write_png(files.add("bent.png"), scaled(*made.bent, 0.5f, 0.5f));
        write_png(files.add("cone.png"), scaled(*made.cone, 2 / std::numbers::pi_v<float>, 0));
    }
    if (made.colour) {
        write_pfm(files.add("color.pfm"), over_white(*made.colour));
        write_png(files.add("color.png"), srgb(over_white(*made.colour)));
    }
    write_pfm(files.add("depth.pfm"), inputs.depth);
    write_pfm(files.add("normal.pfm"), inputs.normal);
    std::vector<exr_channel> channels{{"visibility", made.visibility},
                                      {"depth.Z", inputs.depth},
                                      {"normal.X", inputs.normal, 0},
                                      {"normal.Y", inputs.normal, 1},
                                      {"normal.Z", inputs.normal, 2}};
    if (made.colour)
        for (unsigned c = 0; c < 4; ++c)
            channels.push_back({std::string("color.") + "RGBA"[c], *made.colour, c});
    write_exr(files.add("frame.exr"), channels);
    files.appear(describe(options, from, chosen, settle(chosen, how), times, std::string(device.name())),
                 options.scene.inputs());
    fmt::print("{}: visibility of '{}' from '{}', {} x {}, in {:.2f} ms on {}\n", options.directory.string(),
               options.scene.scene, from.name, from.width, from.height, times.total(), device.name());
}

}

void add_render(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("render", "a scene's G-buffer by rasterisation, and an effect on it");
    const auto options = std::make_shared<render_options>();
    options->scene.add_to(*command);
    add_dynamic_option(*command, options->dynamic);
    command->add_option("--recipe", options->recipe, "SAMPLER/DEPTH/ESTIMATOR[/FILTER...], see `crease list`")
        ->required();
    add_each(*command, "--set", options->settings, "name=value of a setting, see `crease list`");
    command->add_option("--second-camera", options->second_camera,
                        "name of the camera of a second view; else one is placed beside the first");
    command->add_option("--guard", options->guard, "width of the guard band around the picture, texels")
        ->check(whole_number_from(0, 4096));
    add_depth_option(*command, options->depth);
    command->add_option("--frame", options->frame, "index that changes the randomness")
        ->check(whole_number_from(0, std::numeric_limits<std::uint32_t>::max()));
    command->add_option("--device", options->device, "part of the name of a Vulkan device");
    command->add_flag("--validation", options->validation,
                      "with the validation layers, every message an error");
    command->add_option("-o,--output", options->directory, "directory for the files")->required();
    command->callback([options] { run(*options); });
}

}
