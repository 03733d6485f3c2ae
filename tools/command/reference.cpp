// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "image/file.hpp"
#include "progress.hpp"
#include "scene_options.hpp"
#include "truth/truth.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace crease::tools {

namespace {

struct reference_options {
    scene_options scene;
    unsigned rays = 256;
    std::uint32_t seed = 1;
    bool mask = false;
    std::filesystem::path directory;
};

void run(const reference_options& options) {
    const mesh scene = options.scene.load();
    const camera from = options.scene.load_camera();
    progress shown("tracing");
    truth_settings settings{.width = from.width,
                            .height = from.height,
                            .radius = from.ao_radius,
                            .rays = options.rays,
                            .first_layer = options.mask,
                            .seed = options.seed,
                            .progress = [&shown](double done) {
                                shown(done);
                                return true;
                            }};
    const truth traced = trace_truth(scene, from, settings);
    make_directory(options.directory);
    write_pfm(options.directory / "ao_hard.pfm", traced.ao_hard);
    write_pfm(options.directory / "ao_linear.pfm", traced.ao_linear);
    write_pfm(options.directory / "ao_quad.pfm", traced.ao_quad);
    write_pfm(options.directory / "bent.pfm", traced.bent);
    if (options.mask) {
        write_pfm(options.directory / "ao_first_layer.pfm", traced.ao_first_layer);
        write_pfm(options.directory / "mask.pfm", hidden_mask(traced));
        write_png(options.directory / "mask.png", hidden_mask(traced));
    }
    write_pfm(options.directory / "depth.pfm", traced.depth);
    write_pfm(options.directory / "normal.pfm", traced.normal);
    write_png(options.directory / "ao_linear.png", traced.ao_linear);
    const nlohmann::ordered_json meta{
        {"scene", options.scene.scene},  {"camera", from.name},  {"width", from.width},
        {"height", from.height},         {"near", from.near},    {"far", from.far},
        {"radius", from.ao_radius},      {"rays", options.rays}, {"seed", options.seed},
        {"triangles", scene.triangles()}};
    write_atomically(options.directory / "meta.json", meta.dump(2) + "\n");
}

}

void add_reference(CLI::App& app) {
    CLI::App* command = app.add_subcommand("reference", "ray-traced visibility of a scene");
    const auto options = std::make_shared<reference_options>();
    options->scene.add_to(*command);
    command->add_option("--rays", options->rays, "for each texel")
        ->check(CLI::Range(1u, 65536u))
        ->capture_default_str();
    command->add_flag(
        "--mask", options->mask,
        "also where geometry that the camera cannot see takes more than 0.15 of the visibility");
    command->add_option("--seed", options->seed, "of the rays")->capture_default_str();
    command->add_option("-o,--output", options->directory, "directory for the files")->required();
    command->callback([options] { run(*options); });
}

}
