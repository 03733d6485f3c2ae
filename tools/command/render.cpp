// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "frame/frame.hpp"
#include "image/file.hpp"
#include "scene_options.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace crease::tools {

namespace {

struct render_options {
    scene_options scene;
    std::string recipe, device;
    std::vector<std::string> settings;
    bool validation = false;
    std::filesystem::path directory;
};

nlohmann::ordered_json describe(const render_options& options, const camera& from, const recipe& chosen,
                                const parameters& used, const frame& made, const std::string& device) {
    nlohmann::ordered_json settings, passes = nlohmann::ordered_json::array();
    for (const choice& c : complete(chosen.choices()))
        for (const setting& s : c.what->settings)
            settings[std::string(s.name)] = used.*s.field;
    for (const vulkan::pass_time& t : made.passes)
        passes.push_back({{"name", t.pass}, {"milliseconds", t.milliseconds}});
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
            {"passes", passes}};
}

void run(const render_options& options) {
    const recipe chosen{std::string_view(options.recipe)};
    if (!chosen)
        throw std::runtime_error(std::string(chosen.error()));
    const mesh scene = options.scene.load();
    const camera from = options.scene.load_camera();
    const frame_options how{.radius = from.ao_radius, .settings = parse_settings(options.settings)};
    const parameters used = settle(chosen, how);
    vulkan::device device({.name = options.device, .validation = options.validation});
    const gbuffer inputs = rasterise(device, scene, from);
    const frame made = run_effect(device, chosen, inputs, how);
    make_directory(options.directory);
    write_pfm(options.directory / "ao.pfm", made.visibility);
    write_png(options.directory / "ao.png", made.visibility);
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
    command->add_option("--device", options->device, "part of the name of a Vulkan device");
    command->add_flag("--validation", options->validation,
                      "with the validation layers, every message an error");
    command->add_option("-o,--output", options->directory, "directory for the files")->required();
    command->callback([options] { run(*options); });
}

}
