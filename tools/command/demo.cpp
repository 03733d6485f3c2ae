// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "emit/emit.hpp"
#include "frame/frame.hpp"
#include "frame/sheet.hpp"
#include "image/file.hpp"
#include "image/file_set.hpp"
#include "measure/compare.hpp"
#include "progress.hpp"
#include "ranges.hpp"
#include "truth/truth.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace crease::tools {

namespace {

struct shown_recipe {
    const char* directory;
    const char* recipe;
};

constexpr shown_recipe shown_recipes[] = {
    {"ssao", "hemisphere_points:16/single_layer/ssao/bilateral"},
    {"hbao", "directions:4x4/single_layer/hbao/bilateral"},
    {"hbao_plus", "directions:8x4/single_layer/hbao_plus/bilateral"},
    {"hbao_plus_disk", "poisson_disk:16/single_layer/hbao_plus/bilateral"},
    {"hbao_half", "directions:4x4/single_layer/hbao/bilateral:2/upsample:2"},
};

struct demo_options {
    std::filesystem::path directory;
    std::string device;
    unsigned width = 640, height = 360, rays = 256;
};

void emit_both(const std::filesystem::path& directory, const char* recipe_text) {
    emit({.recipe = recipe_text, .formats = {emit_format::glsl, emit_format::spirv}, .directory = directory});
}

double total(const frame& made) {
    double milliseconds = 0;
    for (const vulkan::pass_time& t : made.times.passes)
        milliseconds += t.milliseconds;
    return milliseconds;
}

void run(const demo_options& options) {
    const mesh scene = built_in_scene();
    camera from = built_in_cameras().front();
    from.width = options.width;
    from.height = options.height;
    vulkan::device device({.name = options.device});
    file_set files(options.directory);
    fmt::print("device: {}\n", device.name());

    progress bar("tracing the truth");
    const truth traced = trace_truth(scene, from,
                                     {.width = from.width,
                                      .height = from.height,
                                      .radius = from.ao_radius,
                                      .rays = options.rays,
                                      .progress = [&bar](double done) {
                                          bar(done);
                                          return true;
                                      }});
    write_png(files / "truth.png", traced.ao_linear);
    std::vector<sheet_cell> cells{
        {traced.ao_linear, {"ray-traced truth", fmt::format("{} rays, linear", options.rays)}}};

    const gbuffer inputs = rasterise(device, scene, from);
    std::vector<std::unique_ptr<prepared_effect>> effects;
    for (const auto& shown : shown_recipes)
        effects.push_back(
            std::make_unique<prepared_effect>(device, recipe(std::string_view(shown.recipe)), inputs,
                                              frame_options{.radius = from.ao_radius, .settings = {}}));
    const std::vector<frame_times> times = take_turns(effects, 5);
    std::vector<frame> frames;
    frames.reserve(std::size(shown_recipes)); // cells refer to them
    nlohmann::ordered_json figures = nlohmann::ordered_json::array();
    for (const auto& [name, text] : shown_recipes) {
        const std::filesystem::path directory = files / name;
        emit_both(directory, text);
        const std::size_t i = frames.size();
        frames.push_back(effects[i]->picture());
        frames.back().times = times[i];
        const frame& made = frames.back();
        write_png(directory / "ao.png", made.visibility);
        const comparison error =
            compare(made.visibility, traced.ao_linear, {.depth = &inputs.depth, .far = from.far});
        cells.push_back({made.visibility,
                         {text, fmt::format("{:.1f} ms   RMSE {:.3f}   SSIM {:.3f}", total(made), error.rmse,
                                            error.ssim)}});
        figures.push_back({{"recipe", text},
                           {"milliseconds", total(made)},
                           {"rmse", error.rmse},
                           {"ssim", error.ssim},
                           {"bias", error.bias}});
        fmt::print("{:<60} {:6.1f} ms   RMSE {:.3f}   SSIM {:.3f}\n", text, total(made), error.rmse,
                   error.ssim);
    }
    write_sheet(files / "sheet.png", cells, 2);
    write_atomically(files / "figures.json", figures.dump(2) + "\n");
    files.appear();
    fmt::print("pictures, GLSL and SPIR-V are in {}; begin with sheet.png\n", options.directory.string());
}

}

void add_demo(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("demo", "a built-in scene with a handful of recipes, beside the truth");
    const auto options = std::make_shared<demo_options>();
    command->add_option("-o,--output", options->directory, "directory for the files")->required();
    command->add_option("--device", options->device, "part of the name of a Vulkan device");
    command->add_option("--width", options->width, "texels")
        ->check(whole_number_from(1, 4096))
        ->capture_default_str();
    command->add_option("--height", options->height, "texels")
        ->check(whole_number_from(1, 4096))
        ->capture_default_str();
    command->add_option("--rays", options->rays, "of the truth, for each texel")
        ->check(whole_number_from(1, 65536))
        ->capture_default_str();
    command->callback([options] { run(*options); });
}

}
