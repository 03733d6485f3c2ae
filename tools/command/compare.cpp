// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "image/image.hpp"
#include "measure/compare.hpp"
#include "ranges.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace crease::tools {

namespace {

struct compare_options {
    std::filesystem::path test, reference, depth, difference;
    float far = 0;
    float gain = 4;
    bool as_json = false;
};

void print(const comparison& c, bool as_json) {
    const std::pair<const char*, double> values[] = {
        {"rmse", c.rmse}, {"mae", c.mae},         {"bias", c.bias},      {"psnr_db", c.psnr_db},
        {"ssim", c.ssim}, {"p99_abs", c.p99_abs}, {"max_abs", c.max_abs}};
    if (as_json) {
        nlohmann::ordered_json out{
            {"pixels", c.pixels}, {"background", c.background}, {"nonfinite", c.nonfinite}};
        for (const auto& [name, value] : values)
            out[name] = std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
        fmt::print("{}\n", out.dump());
        return;
    }
    fmt::print("{:<12} {}\n{:<12} {}\n{:<12} {}\n", "pixels", c.pixels, "background", c.background,
               "nonfinite", c.nonfinite);
    for (const auto& [name, value] : values)
        fmt::print("{:<12} {:.6g}\n", name, value);
}

/// Refuses a picture of the difference that would not be one, or would replace what is compared.
void check_difference(const compare_options& options) {
    if (options.difference.extension() != ".png")
        throw CLI::ValidationError(
            "--diff", fmt::format("'{}' is not the name of a .png file", options.difference.string()));
    for (const std::filesystem::path& input : {options.test, options.reference, options.depth}) {
        std::error_code ignored;
        if (std::filesystem::equivalent(options.difference, input, ignored))
            throw CLI::ValidationError("--diff",
                                       fmt::format("'{}' is read by this command and would be replaced",
                                                   options.difference.string()));
    }
}

void run(const compare_options& options) {
    if (!options.difference.empty())
        check_difference(options);
    const image test = read_image(options.test), reference = read_image(options.reference);
    image depth, difference;
    comparison_settings settings;
    if (!options.depth.empty()) {
        depth = read_image(options.depth);
        settings.depth = &depth;
    }
    if (options.far > 0)
        settings.far = options.far;
    if (!options.difference.empty())
        settings.difference = &difference;
    const comparison measured = compare(test, reference, settings);
    if (settings.difference) {
        for (float& texel : difference.texels)
            texel = std::min(texel * options.gain, 1.0f);
        write_png(options.difference, difference);
    }
    print(measured, options.as_json);
}

}

void add_compare(CLI::App& app) {
    CLI::App* command = app.add_subcommand("compare", "how far a picture is from its reference");
    const auto options = std::make_shared<compare_options>();
    command->add_option("test", options->test, "picture (.pfm or .exr)")->required();
    command->add_option("reference", options->reference, "what it should be")->required();
    CLI::Option* depth =
        command->add_option("--depth", options->depth, "linear depth, which tells the background apart");
    command->add_option("--far", options->far, "depth at which background begins; else the largest depth")
        ->check(number_from(1e-38, 1e38))
        ->needs(depth);
    CLI::Option* difference =
        command->add_option("--diff", options->difference, "PNG of the absolute difference");
    command->add_option("--gain", options->gain, "factor of the difference in that PNG")
        ->check(number_from(0, 1e6))
        ->needs(difference)
        ->capture_default_str();
    command->add_flag("--json", options->as_json, "for programs");
    command->callback([options] { run(*options); });
}

}
