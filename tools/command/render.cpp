// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "frame/frame.hpp"
#include "image/file.hpp"
#include "scene_options.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <numbers>

namespace crease::tools {

namespace {

struct render_options {
    scene_options scene;
    std::string recipe, device, second_camera;
    unsigned guard = 0;
    std::uint32_t frame = 0;
    std::vector<std::string> settings;
    bool validation = false;
    std::filesystem::path directory;
};

image scaled(image values, float by, float and_add) {
    for (float& v : values.texels)
        v = v * by + and_add;
    return values;
}

nlohmann::ordered_json times_of(const std::vector<vulkan::pass_time>& times) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const vulkan::pass_time& t : times)
        all.push_back({{"name", t.pass}, {"milliseconds", t.milliseconds}});
    return all;
}

nlohmann::ordered_json describe(const render_options& options, const camera& from, const recipe& chosen,
                                const parameters& used, const frame& made, const std::string& device) {
    nlohmann::ordered_json settings;
    const std::vector<effect_setting> known = settings_of(chosen);
    for (std::size_t i = 0; i < known.size(); ++i)
        settings[name_of(known[i])] = used.settings[i];
    return {{"scene", options.scene.scene},
            {"camera", from.name},
            {"width", from.width},
            {"height", from.height},
            {"near", from.near},
            {"far", from.far},
            {"radius", from.ao_radius},
            {"recipe", std::string(chosen.text().view())},
            {"settings", settings},
            {"device", device},
            {"guard", options.guard},
            {"frame", options.frame},
            {"captures", times_of(made.times.captures)},
            {"passes", times_of(made.times.passes)}};
}

void run(const render_options& options) {
    const recipe wanted{std::string_view(options.recipe)};
    if (!wanted)
        throw std::runtime_error(std::string(wanted.error()));
    const mesh scene = options.scene.load();
    const camera from = options.scene.load_camera();
    frame_options how{
        .radius = from.ao_radius, .settings = parse_settings(options.settings), .frame = options.frame};
    if (!options.second_camera.empty())
        how.second = find_camera(options.scene.load_all_cameras(), options.second_camera);
    const parameters used = settle(wanted, how);
    vulkan::device device({.name = options.device, .validation = options.validation});
    const recipe chosen = supported(device, wanted);
    const gbuffer inputs = rasterise(device, scene, from, options.guard);
    const frame made = run_effect(device, chosen, inputs, how);
    make_directory(options.directory);
    write_pfm(options.directory / "ao.pfm", made.visibility);
    write_png(options.directory / "ao.png", made.visibility);
    if (made.bent) {
        write_pfm(options.directory / "bent.pfm", *made.bent);
        write_pfm(options.directory / "cone.pfm", *made.cone);
        write_png(options.directory / "bent.png", scaled(*made.bent, 0.5f, 0.5f));
        write_png(options.directory / "cone.png", scaled(*made.cone, 2 / std::numbers::pi_v<float>, 0));
    }
    write_pfm(options.directory / "depth.pfm", inputs.depth);
    write_pfm(options.directory / "normal.pfm", inputs.normal);
    const exr_channel channels[] = {{"visibility", made.visibility},
                                    {"depth.Z", inputs.depth},
                                    {"normal.X", inputs.normal, 0},
                                    {"normal.Y", inputs.normal, 1},
                                    {"normal.Z", inputs.normal, 2}};
    write_exr(options.directory / "frame.exr", channels);
    write_atomically(options.directory / "meta.json",
                     describe(options, from, chosen, used, made, std::string(device.name())).dump(2) + "\n");
}

}

void add_render(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("render", "a scene's G-buffer by rasterisation, and an effect on it");
    const auto options = std::make_shared<render_options>();
    options->scene.add_to(*command);
    command->add_option("--recipe", options->recipe, "SAMPLER/DEPTH/ESTIMATOR[/FILTER...], see `crease list`")
        ->required();
    command->add_option("--set", options->settings,
                        "name=value of a setting, see `crease list`; may be repeated");
    command->add_option("--second-camera", options->second_camera,
                        "name of the camera of a second view; else one is placed beside the first");
    command->add_option("--guard", options->guard, "width of the guard band around the picture, texels")
        ->check(CLI::Range(0u, 4096u));
    command->add_option("--frame", options->frame, "index that changes the randomness");
    command->add_option("--device", options->device, "part of the name of a Vulkan device");
    command->add_flag("--validation", options->validation,
                      "with the validation layers, every message an error");
    command->add_option("-o,--output", options->directory, "directory for the files")->required();
    command->callback([options] { run(*options); });
}

}
