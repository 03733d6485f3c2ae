// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "progress.hpp"
#include "ranges.hpp"
#include "result_files.hpp"
#include "scene_options.hpp"
#include "truth/truth.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <memory>

namespace crease::tools {

namespace {

struct reference_options {
    scene_options scene;
    unsigned rays = 256;
    std::uint32_t seed = 1;
    bool mask = false, hull = false;
    std::filesystem::path directory;
};

void run(const reference_options& options) {
    const mesh scene = scene_of(options.scene.scene, options.scene.opacity);
    check_hull(options.hull, scene);
    const camera from = options.scene.choose(cameras_of(options.scene.scene, scene, options.scene.cameras));
    progress shown("tracing");
    truth_settings settings{.width = from.width,
                            .height = from.height,
                            .radius = from.ao_radius,
                            .rays = options.rays,
                            .first_layer = options.mask,
                            .hull = options.hull,
                            .seed = options.seed,
                            .progress = [&shown](double done) {
                                shown(done);
                                return true;
                            }};
    const truth traced = trace_truth(scene, from, settings);
    check_sight(from, traced.depth);
    result_files files(options.directory);
    write_pfm(files.add("ao_hard.pfm"), traced.ao_hard);
    write_pfm(files.add("ao_linear.pfm"), traced.ao_linear);
    write_pfm(files.add("ao_quad.pfm"), traced.ao_quad);
    write_pfm(files.add("bent.pfm"), traced.bent);
    if (options.mask) {
        write_pfm(files.add("ao_first_layer.pfm"), traced.ao_first_layer);
        write_pfm(files.add("mask.pfm"), hidden_mask(traced));
        write_png(files.add("mask.png"), hidden_mask(traced));
    }
    write_pfm(files.add("depth.pfm"), traced.depth);
    write_pfm(files.add("normal.pfm"), traced.normal);
    write_png(files.add("ao_linear.png"), traced.ao_linear);
    nlohmann::ordered_json meta = described(options.scene, from);
    meta.update({{"rays", options.rays}, {"seed", options.seed}, {"triangles", scene.triangles()}});
    if (is_transparent(scene))
        meta["transparent"] = options.hull ? "thin hulls" : "solids";
    files.appear(meta, options.scene.inputs());
    fmt::print("{}: visibility of '{}' from '{}', {} x {}, by {} rays a texel\n", options.directory.string(),
               options.scene.scene, from.name, from.width, from.height, options.rays);
}

}

void add_reference(CLI::App& app) {
    CLI::App* command = app.add_subcommand("reference", "ray-traced visibility of a scene");
    const auto options = std::make_shared<reference_options>();
    options->scene.add_to(*command);
    command->add_option("--rays", options->rays, "for each texel")
        ->check(whole_number_from(1, 65536))
        ->capture_default_str();
    command->add_flag(
        "--mask", options->mask,
        "also where geometry that the camera cannot see takes more than 0.15 of the visibility");
    add_hull_option(*command, options->hull);
    command->add_option("--seed", options->seed, "of the rays")
        ->check(whole_number_from(0, std::numeric_limits<std::uint32_t>::max()))
        ->capture_default_str();
    command->add_option("-o,--output", options->directory, "directory for the files")->required();
    command->callback([options] { run(*options); });
}

}
