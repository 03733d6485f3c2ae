// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "candidate.hpp"
#include "image/file.hpp"
#include "image/file_set.hpp"
#include "measure/compare.hpp"
#include "progress.hpp"
#include "ranges.hpp"
#include "tune/chart.hpp"
#include "tune/search.hpp"
#include "views.hpp"

#include <crease/effect/version.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <limits>
#include <memory>
#include <optional>

namespace crease::tools {

namespace {

struct tune_options {
    view_options views{.width = 640, .height = 360};
    std::vector<std::string> recipes{"preset:low", "preset:medium", "preset:high", "preset:ultra"};
    std::string device, truth = "linear";
    budget limits;
    unsigned trials = 100, repeats = 5, seed = 1;
    std::filesystem::path directory;
};

/// Ends a search after the trial that runs: the first interrupt asks for it, the second ends the process.
class interrupt_flag {
public:
    interrupt_flag() { before_ = std::signal(SIGINT, ask); }
    ~interrupt_flag() { std::signal(SIGINT, before_); }
    interrupt_flag(const interrupt_flag&) = delete;
    interrupt_flag& operator=(const interrupt_flag&) = delete;

    bool is_asked() const { return asked_ != 0; }

private:
    static void ask(int) {
        asked_ = 1;
        std::signal(SIGINT, SIG_DFL);
    }

    static inline volatile std::sig_atomic_t asked_ = 0;
    void (*before_)(int);
};

const image& truth_of(const subject& view, const tune_options& options) {
    return options.truth == "hard" ? view.traced.ao_hard : view.traced.ao_linear;
}

double error_of(const frame& made, const subject& view, const tune_options& options) {
    return compare(made.visibility, truth_of(view, options), view.mask_of_background()).rmse;
}

/// The error of a candidate over views, their mean.
double mean_error(vulkan::device& device, const candidate& of, const std::vector<const subject*>& views,
                  const tune_options& options) {
    double sum = 0;
    for (const subject* view : views)
        sum +=
            error_of(run_effect(device, of.chosen, view->inputs, of.options_for(view->from)), *view, options);
    return sum / static_cast<double>(views.size());
}

void measure(vulkan::device& device, trial& of, const std::vector<const subject*>& views,
             const tune_options& options) {
    const candidate read = parse_candidate(of.candidate);
    const camera& from = views[0]->from;
    for (const pass_work& p : work_of(supported(device, seen_by(from, read.chosen)))) {
        const bool countable = p.of_pixel.counted_whole;
        of.instructions +=
            countable ? p.share * p.of_pixel.instructions : std::numeric_limits<double>::infinity();
        of.fetches += countable ? p.share * p.of_pixel.fetches : std::numeric_limits<double>::infinity();
    }
    of.error = mean_error(device, read, views, options);
    const std::unique_ptr<prepared_effect> effect[] = {
        std::make_unique<prepared_effect>(device, read.chosen, views[0]->inputs, read.options_for(from))};
    of.milliseconds = take_turns(effect, options.repeats)[0].total();
}

trial tried(vulkan::device& device, const std::string& text, const std::vector<const subject*>& views,
            const tune_options& options) {
    trial made{.candidate = text, .refused = {}};
    try {
        measure(device, made, views, options);
    } catch (const std::runtime_error& error) {
        made = {.candidate = text, .refused = error.what()};
    }
    return made;
}

/// What the figures of a search follow from.
nlohmann::ordered_json setup_of(const tune_options& options, const std::vector<subject>& views,
                                std::string_view device) {
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const subject& view : views)
        names.push_back(view.name + " " + view.from.name);
    nlohmann::ordered_json setup{{"crease", version},
                                 {"device", device},
                                 {"views", names},
                                 {"width", options.views.width},
                                 {"height", options.views.height},
                                 {"guard", options.views.guard},
                                 {"depth", name_of(options.views.depth)},
                                 {"rays", options.views.rays},
                                 {"truth", options.truth},
                                 {"recipes", options.recipes},
                                 {"seed", options.seed}};
    if (options.limits.milliseconds)
        setup["budget_ms"] = *options.limits.milliseconds;
    if (options.limits.instructions)
        setup["budget_instructions"] = *options.limits.instructions;
    if (options.limits.error)
        setup["budget_error"] = *options.limits.error;
    return setup;
}

/// A trial with its error over the views that the search did not see.
struct finalist {
    trial what;
    double held_out = 0;
};

void print(const finalist& of) {
    fmt::print(
        "{:7.0f} instructions {:5.1f} fetches {:7.2f} ms   error {:.4f}, on views kept out {:.4f}   {}\n",
        of.what.instructions, of.what.fetches, of.what.milliseconds, of.what.error, of.held_out,
        of.what.candidate);
}

nlohmann::ordered_json described(const finalist& of) {
    nlohmann::ordered_json told = described(of.what);
    told["error_kept_out"] = of.held_out;
    return told;
}

std::string chart_of(const std::vector<trial>& trials, const std::vector<finalist>& front,
                     const tune_options& options) {
    std::vector<chart_point> points;
    for (const trial& t : trials)
        if (t.refused.empty() && std::isfinite(options.limits.cost_of(t)))
            points.push_back({options.limits.cost_of(t), t.error, ""});
    for (const finalist& f : front)
        points.push_back({options.limits.cost_of(f.what), f.what.error,
                          fmt::format("{:.4g}   {:.4f} ({:.4f})   {}", options.limits.cost_of(f.what),
                                      f.what.error, f.held_out, f.what.candidate)});
    return front_chart(
        points, options.limits.milliseconds ? "milliseconds" : "instructions a pixel",
        fmt::format("RMSE to the {} truth (in brackets: on views that were kept out)", options.truth));
}

void run(const tune_options& options) {
    for (const std::string& text : options.recipes)
        parse_candidate(text);
    refuse_recipes_among(options.views.scenes);
    make_directory(options.directory);
    view_options wanted = options.views;
    if (wanted.truths.empty())
        wanted.truths = options.directory / "truths";
    vulkan::device device({.name = options.device});
    const std::vector<subject> all = load_subjects(device, wanted);
    if (all.size() < 2)
        throw std::runtime_error("a search needs two views or more, as half of them are kept out of it");
    std::vector<const subject*> views, kept_out;
    for (std::size_t i = 0; i < all.size(); ++i)
        (i % 2 == 0 ? views : kept_out).push_back(&all[i]);
    const std::filesystem::path file = options.directory / "state.json";
    search_state state = read_state(file, setup_of(options, all, device.name()));
    {
        const interrupt_flag interrupt;
        progress bar("searching");
        while (state.trials.size() < options.trials) {
            const std::size_t at = state.trials.size();
            const std::optional<std::string> next =
                at < options.recipes.size() ? std::optional(options.recipes[at])
                                            : next_candidate(state.trials, options.limits, options.seed);
            if (!next)
                break;
            state.trials.push_back(tried(device, *next, views, options));
            write_state(file, state);
            bar(static_cast<double>(at + 1) / options.trials);
            if (interrupt.is_asked())
                throw std::runtime_error(
                    fmt::format("interrupted after {} of {} trials, which {} keeps; the same command goes on",
                                state.trials.size(), options.trials, file.string()));
        }
    }
    std::vector<finalist> front;
    nlohmann::ordered_json told = nlohmann::ordered_json::array();
    for (std::size_t i : front_of(state.trials, options.limits)) {
        const trial& t = state.trials[i];
        front.push_back({t, mean_error(device, parse_candidate(t.candidate), kept_out, options)});
        print(front.back());
        told.push_back(described(front.back()));
    }
    if (front.empty())
        throw std::runtime_error(fmt::format("none of the {} candidates could be run; {} says why",
                                             state.trials.size(), file.string()));
    nlohmann::ordered_json whole{{"setup", state.setup}, {"trials", state.trials.size()}, {"front", told}};
    const std::optional<std::size_t> best = best_of(state.trials, options.limits);
    whole["best"] = best ? nlohmann::ordered_json(state.trials[*best].candidate) : nlohmann::ordered_json();
    file_set files(options.directory);
    write_atomically(files / "front.json", whole.dump(2) + "\n");
    write_atomically(files / "front.svg", chart_of(state.trials, front, options));
    files.appear();
    if (best)
        fmt::print("best within the budget: {}\n", state.trials[*best].candidate);
    else if (options.limits.milliseconds || options.limits.instructions || options.limits.error)
        fmt::print("no candidate keeps to the budget\n");
}

}

void add_tune(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "tune", "search of recipes and settings for the least error within a budget, or the least cost");
    const auto options = std::make_shared<tune_options>();
    options->views.add_to(*command);
    add_each(*command, "--recipes", options->recipes,
             "a recipe to begin with, RECIPE[@name=value,...]; else the presets of one layer");
    command->add_option("--truth", options->truth, "hard or linear: which occlusion is aimed at")
        ->check(CLI::IsMember({"hard", "linear"}))
        ->capture_default_str();
    CLI::Option_group* limits =
        command->add_option_group("budget", "one of these, or none for the whole front");
    limits
        ->add_option("--budget-ms", options->limits.milliseconds,
                     "the most milliseconds of all passes on the first view; costs are then milliseconds")
        ->check(number_from(0, 1e9));
    limits
        ->add_option(
            "--budget-instructions", options->limits.instructions,
            "the most instructions a pixel, which are the costs otherwise: the same on a busy machine")
        ->check(number_from(0, 1e9));
    limits
        ->add_option("--budget-error", options->limits.error,
                     "the most RMSE, of which the cheapest is sought")
        ->check(number_from(0, 1));
    limits->require_option(0, 1);
    command
        ->add_option("--trials", options->trials, "candidates that are tried, those of --recipes among them")
        ->check(whole_number_from(1, 100000))
        ->capture_default_str();
    command->add_option("--repeats", options->repeats, "timed runs of each candidate; the median counts")
        ->check(whole_number_from(1, 1000))
        ->capture_default_str();
    command->add_option("--seed", options->seed, "of the search; the same gives the same candidates")
        ->check(whole_number_from(0, std::numeric_limits<unsigned>::max()))
        ->capture_default_str();
    command->add_option("--device", options->device, "part of the name of a Vulkan device");
    command
        ->add_option(
            "-o,--output", options->directory,
            "directory for state.json, by which an interrupted search goes on, front.json and front.svg")
        ->required();
    command->callback([options] { run(*options); });
}

}
