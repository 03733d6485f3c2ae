// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "candidate.hpp"
#include "frame/fetch_loop.hpp"
#include "frame/table_copy.hpp"
#include "frame/table_doubling.hpp"
#include "measure/compare.hpp"
#include "progress.hpp"
#include "ranges.hpp"
#include "views.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace crease::tools {

namespace {

struct bench_options {
    view_options views{.moved = true};
    std::vector<std::string> recipes{"preset:low",
                                     "preset:medium",
                                     "preset:high",
                                     "preset:ultra",
                                     "hemisphere_points:16/single_layer/ssao/bilateral",
                                     "directions:4x4/single_layer/hbao/bilateral",
                                     "directions:4x8/single_layer/hbao/bilateral",
                                     "directions:8x4/single_layer/hbao/bilateral",
                                     "directions:8x4/single_layer/hbao_plus/bilateral",
                                     "poisson_disk:16/single_layer/hbao_plus/bilateral",
                                     "directions:4x4/single_layer/hbao/bilateral:2/upsample:2"};
    std::vector<std::string> settings;
    std::string device;
    unsigned repeats = 15;
    bool as_json = false;
};

struct score {
    double milliseconds = 0, capture_milliseconds = 0;
    double rmse_hard = 0, rmse_linear = 0, rmse_quad = 0, ssim = 0, bias = 0, change = 0;
};

/// What else a view can say of a picture: the error where hidden geometry matters, and the angle to the bent
/// normal.
void add_particulars(nlohmann::ordered_json& row, const subject& view, const frame& made) {
    if (std::ranges::count(view.mask.texels, 1.0f) > 0) {
        image depth = view.inputs.depth;
        for (std::size_t i = 0; i < depth.texels.size(); ++i)
            if (view.mask.texels[i] == 0)
                depth.texels[i] = view.from.far;
        const comparison hidden =
            compare(made.visibility, view.traced.ao_linear, {.depth = &depth, .far = view.from.far});
        row["rmse_hidden"] = hidden.rmse;
        row["bias_hidden"] = hidden.bias;
        row["pixels_hidden"] = hidden.pixels;
    }
    if (made.bent)
        row["bent_degrees"] = mean_angle(*made.bent, view.traced.bent);
}

/// The times of the candidates on the first view.
std::vector<frame_times> time_candidates(vulkan::device& device, const std::vector<candidate>& candidates,
                                         const subject& view, unsigned repeats) {
    std::vector<std::unique_ptr<prepared_effect>> effects;
    for (const candidate& each : candidates)
        effects.push_back(
            std::make_unique<prepared_effect>(device, each.chosen, view.inputs, each.options_for(view.from)));
    progress bar("timing by turns");
    return take_turns(effects, repeats, [&bar](double done) { bar(done); });
}

nlohmann::ordered_json measure(vulkan::device& device, const candidate& of, const frame_times& times,
                               const std::vector<subject>& views) {
    nlohmann::ordered_json captures = nlohmann::ordered_json::array(),
                           passes = nlohmann::ordered_json::array(), each = nlohmann::ordered_json::array();
    score mean;
    const recipe run = supported(device, seen_by(views[0].from, of.chosen));
    for (const pass_work& p : work_of(run)) {
        const double milliseconds = times.passes[passes.size()].milliseconds;
        passes.push_back({{"name", p.name},
                          {"fetches", p.of_pixel.fetches},
                          {"instructions", p.of_pixel.instructions},
                          {"milliseconds", milliseconds}});
        mean.milliseconds += milliseconds;
    }
    for (const vulkan::pass_time& t : times.captures) {
        captures.push_back({{"name", t.pass}, {"milliseconds", t.milliseconds}});
        mean.capture_milliseconds += t.milliseconds;
    }
    for (const subject& view : views) {
        const frame made = run_effect(device, of.chosen, view.inputs, of.options_for(view.from));
        const comparison_settings mask = view.mask_of_background();
        const comparison linear = compare(made.visibility, view.traced.ao_linear, mask);
        const double share = 1.0 / static_cast<double>(views.size());
        const double hard = compare(made.visibility, view.traced.ao_hard, mask).rmse;
        const frame after = run_effect(device, of.chosen, view.moved, of.options_for(view.from));
        const double change = compare(after.visibility, made.visibility, mask).mae;
        const double quad = compare(made.visibility, view.traced.ao_quad, mask).rmse;
        mean.rmse_hard += share * hard;
        mean.rmse_quad += share * quad;
        mean.rmse_linear += share * linear.rmse;
        mean.ssim += share * linear.ssim;
        mean.bias += share * linear.bias;
        mean.change += share * change;
        each.push_back({{"scene", view.name},
                        {"camera", view.from.name},
                        {"rmse_hard", hard},
                        {"rmse_linear", linear.rmse},
                        {"rmse_quad", quad},
                        {"ssim", linear.ssim},
                        {"bias", linear.bias},
                        {"change", change}});
        add_particulars(each.back(), view, made);
    }
    return {{"recipe", of.text},
            {"run", std::string(run.text().view())},
            {"milliseconds", mean.milliseconds},
            {"capture_milliseconds", mean.capture_milliseconds},
            {"rmse_hard", mean.rmse_hard},
            {"rmse_linear", mean.rmse_linear},
            {"rmse_quad", mean.rmse_quad},
            {"ssim", mean.ssim},
            {"bias", mean.bias},
            {"change", mean.change},
            {"captures", captures},
            {"passes", passes},
            {"views", each}};
}

void print(const nlohmann::ordered_json& row) {
    fmt::print(
        "{:<58} {:7.2f} ms   RMSE hard {:.4f} linear {:.4f} quad {:.4f}   SSIM {:.4f}   bias {:+.4f}   "
        "change {:.4f}\n",
        row["recipe"].get<std::string>(), row["milliseconds"].get<double>(), row["rmse_hard"].get<double>(),
        row["rmse_linear"].get<double>(), row["rmse_quad"].get<double>(), row["ssim"].get<double>(),
        row["bias"].get<double>(), row["change"].get<double>());
    for (const auto& c : row["captures"])
        fmt::print("    {:<54} {:7.2f} ms\n", c["name"].get<std::string>(), c["milliseconds"].get<double>());
    for (const auto& v : row["views"])
        for (const char* extra : {"rmse_hidden", "bias_hidden", "bent_degrees"})
            if (v.contains(extra))
                fmt::print("    {:<54} {:7.4f}\n",
                           fmt::format("{} of {} {}", extra, v["scene"].get<std::string>(),
                                       v["camera"].get<std::string>()),
                           v[extra].get<double>());
    for (const auto& p : row["passes"])
        fmt::print("    {:<54} {:7.2f} ms   {} fetches, {} instructions a pixel\n",
                   p["name"].get<std::string>(), p["milliseconds"].get<double>(),
                   p["fetches"].get<unsigned>(), p["instructions"].get<unsigned>());
}

/// A pass of the bench's own, which says what the device can do.
struct baseline {
    std::string key, title;
    double milliseconds = 0;
};

/// The baselines that the recipes are to be compared with: those of tables only where a recipe has tables.
std::vector<baseline> time_baselines(vulkan::device& device, const gbuffer& inputs,
                                     const std::vector<candidate>& candidates, const bench_options& options) {
    std::vector<baseline> all = {{"fetch_loop_milliseconds", "32 fetches of depth and no more",
                                  time_fetch_loop(device, inputs, options.repeats)}};
    const bool tables = std::ranges::any_of(candidates, [](const candidate& each) {
        return std::ranges::any_of(each.chosen.choices(), [](const choice& c) {
            return has(c.what->offers, &layers_of_areas::value);
        });
    });
    if (!tables)
        return all;
    all.push_back({"table_copy_milliseconds", "a copy of as many texels of rgba32_float",
                   time_table_copy(device, options.views.width, options.views.height, options.repeats)});
    all.push_back({"table_doubling_milliseconds", "their summed-area table by recursive doubling",
                   time_table_doubling(device, options.views.width, options.views.height, options.repeats)});
    return all;
}

/// What `supported` adds to the recipes, each once.
std::string added_parts(const vulkan::device& device, const std::vector<candidate>& candidates,
                        const camera& from) {
    std::string added;
    for (const candidate& each : candidates) {
        const recipe whole = supported(device, seen_by(from, each.chosen));
        const array_view<const choice> choices = whole.choices();
        for (std::size_t i = each.chosen.choices().size(); i < choices.size(); ++i) {
            const std::string name = "/" + std::string(choices[i].what->name);
            if (added.find(name) == std::string::npos)
                added += (added.empty() ? "" : ", ") + name;
        }
    }
    return added;
}

void run(const bench_options& options) {
    std::vector<candidate> candidates;
    for (const std::string& text : options.recipes)
        candidates.push_back(parse_candidate(text, options.settings));
    refuse_recipes_among(options.views.scenes);
    vulkan::device device({.name = options.device});
    const std::vector<subject> views = load_subjects(device, options.views);
    const std::vector<baseline> baselines = time_baselines(device, views[0].inputs, candidates, options);
    const std::vector<frame_times> times = time_candidates(device, candidates, views[0], options.repeats);
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    if (!options.as_json) {
        fmt::print(
            "{}, {} x {}, times on {} {}, errors the mean of {} views, change that of a pixel when the "
            "camera turns by half of one\n",
            device.name(), options.views.width, options.views.height, views[0].name, views[0].from.name,
            views.size());
        if (const std::string added = added_parts(device, candidates, views[0].from); !added.empty())
            fmt::print(
                "added to recipes as suits the device and the camera, where they name none of the kind: {}\n",
                added);
        for (const baseline& b : baselines)
            fmt::print("{:<58} {:7.2f} ms\n", b.title, b.milliseconds);
    }
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        rows.push_back(measure(device, candidates[i], times[i], views));
        if (!options.as_json)
            print(rows.back());
    }
    if (!options.as_json)
        return;
    nlohmann::ordered_json whole = {{"device", std::string(device.name())},
                                    {"width", options.views.width},
                                    {"height", options.views.height},
                                    {"depth", name_of(options.views.depth)}};
    for (const baseline& b : baselines)
        whole[b.key] = b.milliseconds;
    whole["recipes"] = rows;
    fmt::print("{}\n", whole.dump(2));
}

}

void add_bench(CLI::App& app) {
    CLI::App* command = app.add_subcommand("bench", "cost and error of recipes on scenes");
    const auto options = std::make_shared<bench_options>();
    options->views.add_to(*command);
    add_each(*command, "--recipes", options->recipes,
             "a recipe to measure, RECIPE[@name=value,...]; else a handful");
    command->add_flag(
        "--hidden", options->views.hidden,
        "also the error where geometry that the camera cannot see takes more than 0.15 of the visibility");
    add_each(*command, "--set", options->settings, "name=value of a setting, for all recipes");
    command->add_option("--device", options->device, "part of the name of a Vulkan device");
    command
        ->add_option("--repeats", options->repeats,
                     "timed runs, in which the recipes take turns; the median counts")
        ->check(whole_number_from(1, 1000))
        ->capture_default_str();
    command->add_flag("--json", options->as_json, "for programs");
    command->callback([options] { run(*options); });
}

}
