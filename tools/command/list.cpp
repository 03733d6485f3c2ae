// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "preset_figures.hpp"

#include <crease/compose/composition.hpp>
#include <crease/parts/all_parts.hpp>
#include <crease/parts/presets.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace crease::tools {

namespace {

using json = nlohmann::ordered_json;

/// Whether two of the three main parts go together with some third.
bool fit(const part& sampler, const part& depth_source, const part& estimator) {
    const auto chosen = [](const part& p) {
        choice c{&p, {}};
        for (std::size_t i = 0; i < p.numbers.size(); ++i)
            c.numbers[i] = p.numbers[i].fallback;
        return c;
    };
    const choice choices[] = {chosen(sampler), chosen(depth_source), chosen(estimator)};
    return !check(choices);
}

/// The recipes of three parts that make an effect.
std::vector<std::string> legal_triples() {
    std::vector<std::string> recipes;
    for (const part* s : all_parts)
        for (const part* d : all_parts)
            for (const part* e : all_parts)
                if (s->kind == role::sampler && d->kind == role::depth_source && e->kind == role::estimator &&
                    fit(*s, *d, *e))
                    recipes.push_back(fmt::format("{}/{}/{}", s->name, d->name, e->name));
    return recipes;
}

device_features required_by(const std::string& text) {
    const recipe chosen{std::string_view(text)};
    return std::make_unique<composition>(chosen)->view().features;
}

json describe(const part& p) {
    json numbers = json::array(), settings = json::array();
    for (const number& n : p.numbers)
        numbers.push_back({{"name", n.name},
                           {"least", n.least},
                           {"most", n.most},
                           {"default", n.fallback},
                           {"meaning", n.meaning}});
    for (const setting& s : p.settings)
        settings.push_back({{"name", s.name},
                            {"least", s.least},
                            {"most", s.most},
                            {"default", s.fallback},
                            {"meaning", s.meaning},
                            {"shared", s.shared}});
    return {{"name", p.name},     {"role", name_of(p.kind)}, {"summary", p.summary},
            {"source", p.source}, {"numbers", numbers},      {"settings", settings}};
}

/// The settings of a preset that differ from what its parts recommend.
json settings_of_preset(const preset_description& p) {
    json settings = json::object();
    for (const choice& c : p.parts)
        for (const setting_value& own : c.settings)
            settings[fmt::format("{}.{}", c.what->name, own.name)] = own.value;
    return settings;
}

json describe(const preset_description& p) {
    json told{{"name", p.name},
              {"summary", p.summary},
              {"recipe", fmt::format("preset:{}", p.name)},
              {"parts", recipe(p.parts).text().view()},
              {"settings", settings_of_preset(p)}};
    for (const preset_figures& f : measured_presets)
        if (f.preset == p.name)
            told["figures"] = {{"rmse_hard", f.rmse_hard},
                               {"rmse_linear", f.rmse_linear},
                               {"ssim_linear", f.ssim_linear},
                               {"time", f.time}};
    return told;
}

void print_json() {
    json parts = json::array(), recipes = json::array(), presets = json::array();
    for (const preset_description* p : all_presets)
        presets.push_back(describe(*p));
    for (const part* p : all_parts)
        parts.push_back(describe(*p));
    for (const std::string& text : legal_triples())
        recipes.push_back(
            {{"recipe", text},
             {"features", {{"extended_storage_formats", required_by(text).extended_storage_formats}}}});
    fmt::print("{}\n", json{{"presets", presets}, {"parts", parts}, {"recipes", recipes}}.dump(2));
}

/// The roles in the order in which the index of parts names them.
std::vector<role> roles_in_order() {
    std::vector<role> roles;
    for (const part* p : all_parts)
        if (std::ranges::find(roles, p->kind) == roles.end())
            roles.push_back(p->kind);
    return roles;
}

void print_part(const part& p) {
    fmt::print("  {:<22} {}\n", p.name, p.summary);
    if (!p.source.empty())
        fmt::print("  {:<22}   from {}\n", "", p.source);
    for (const number& n : p.numbers)
        fmt::print("  {:<22}   :{} {} to {}, else {}: {}\n", "", n.name, n.least, n.most, n.fallback,
                   n.meaning);
    for (const setting& s : p.settings)
        fmt::print("  {:<22}   --set {}{}{}={} ({} to {}{}): {}\n", "", s.shared ? "" : p.name,
                   s.shared ? "" : ".", s.name, s.fallback, s.least, s.most,
                   s.shared ? ", for all parts that have it" : "", s.meaning);
}

void print_text() {
    fmt::print("presets, preset:NAME[/PART...]: a part takes the place of those of its role\n");
    for (const preset_description* p : all_presets)
        fmt::print("  {:<22} {}\n  {:<22}   {}\n", p->name, p->summary, "", recipe(p->parts).text().view());
    for (role r : roles_in_order()) {
        fmt::print("\n{}\n", name_of(r));
        for (const part* p : all_parts)
            if (p->kind == r)
                print_part(*p);
    }
    fmt::print("\nwhat fits with what: SAMPLER/DEPTH/ESTIMATOR, then /FILTER... and what differs from the "
               "defaults\n");
    for (const std::string& text : legal_triples())
        fmt::print("  {}{}\n", text,
                   required_by(text).extended_storage_formats
                       ? "   (compute: shaderStorageImageExtendedFormats)"
                       : "");
}

}

void add_list(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "list", "the presets, the parts, what fits with what, numbers, settings and papers");
    static bool as_json = false;
    command->add_flag("--json", as_json, "for programs");
    command->callback([] { as_json ? print_json() : print_text(); });
}

}
