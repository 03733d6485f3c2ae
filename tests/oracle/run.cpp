// SPDX-License-Identifier: MIT
#include "run.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>

namespace oracle {

crease::vulkan::device& device() {
    static crease::vulkan::device only({.name = "", .validation = true});
    return only;
}

crease::parameters view_parameters(const picture& p, const crease::effect_view& effect, double radius) {
    crease::parameters how = effect.defaults;
    float matrix[16];
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            matrix[column * 4 + row] = static_cast<float>(p.projection[column][row]);
    if (const auto fit = crease::set_projection(how.view, matrix, static_cast<unsigned>(p.width),
                                                static_cast<unsigned>(p.height));
        !fit)
        throw std::runtime_error(std::string(fit.error));
    how.radius = static_cast<float>(radius);
    return how;
}

prepared::prepared(const crease::recipe& of, const picture& p, const std::map<std::string, int>& constants)
    : composed(of),
      runner(device(), composed, static_cast<unsigned>(p.width), static_cast<unsigned>(p.height),
             {.guard = 0, .constants = constants, .shaders = {}}) {}

prepared& prepare(const std::string& recipe_text, const picture& p,
                  const std::map<std::string, int>& constants) {
    using key = std::tuple<std::string, int, int, std::map<std::string, int>>;
    static_cast<void>(device()); // made first, so that it is destroyed last
    static std::map<key, std::unique_ptr<prepared>> kept;
    const auto there = kept.find({recipe_text, p.width, p.height, constants});
    if (there != kept.end())
        return *there->second;
    const crease::recipe chosen{std::string_view(recipe_text)};
    if (!chosen)
        throw std::invalid_argument(std::string(chosen.error()));
    if (kept.size() == 64)
        kept.clear();
    return *(kept[{recipe_text, p.width, p.height, constants}] =
                 std::make_unique<prepared>(chosen, p, constants));
}

void upload(crease::vulkan::runner& runner, const crease::effect_view& effect, const picture& p) {
    for (const crease::resource& input : effect.resources) {
        if (input.name == "depth") {
            std::vector<float> depth = p.device;
            if (input.texels == crease::format::r32_float) // linear depth
                for (int y = 0; y < p.height; ++y)
                    for (int x = 0; x < p.width; ++x)
                        depth[p.index(x, y)] =
                            static_cast<float>(p.background(x, y) ? 1e9 : -p.position(x, y).z);
            runner.upload("depth", depth);
        } else if (input.name == "normal") {
            std::vector<float> normals;
            for (const glm::vec3& n : p.normals)
                normals.insert(normals.end(), {n.x, n.y, n.z, 0.0f});
            runner.upload("normal", normals);
        }
    }
}

std::vector<float> run(const picture& p, const crease::effect_view& effect, const crease::parameters& how,
                       std::string_view image) {
    crease::vulkan::runner runner(device(), effect, static_cast<unsigned>(p.width),
                                  static_cast<unsigned>(p.height));
    upload(runner, effect, p);
    runner.run(how);
    return runner.download(image);
}

std::vector<float> run(const picture& p, const std::string& recipe_text, double radius) {
    auto& [composed, runner] = prepare(recipe_text, p);
    upload(runner, composed, p);
    runner.run(view_parameters(p, composed, radius));
    return runner.download("visibility");
}

void set(crease::parameters& how, const crease::effect_view& effect, std::string_view name, double value) {
    REQUIRE_MESSAGE(crease::set(how, effect.settings, name, static_cast<float>(value)), name);
}

settings settings_of(const crease::parameters& how, const crease::effect_view& effect) {
    struct named {
        std::string_view name;
        double settings::*field;
    };
    settings found{.radius = how.radius, .frame = how.frame};
    for (const named& each : {named{"bias", &settings::bias},
                              {"threshold", &settings::threshold},
                              {"strength", &settings::strength},
                              {"exponent", &settings::exponent},
                              {"sharpness", &settings::sharpness},
                              {"falloff", &settings::falloff},
                              {"thickness", &settings::thickness},
                              {"thin_occluders", &settings::thin_occluders},
                              {"plane_reach", &settings::plane_reach}})
        for (std::size_t i = 0; i < effect.settings.size(); ++i)
            if (effect.settings[i].is(each.name))
                found.*each.field = double{how.settings[i]};
    return found;
}

difference compare(const std::vector<float>& shader, const std::vector<double>& expected, int width) {
    const std::size_t columns = static_cast<std::size_t>(width), rows = expected.size() / columns;
    std::vector<double> apart;
    difference found;
    double sides[4] = {}; // top, bottom, left, right
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const double signed_apart = shader.at(i) - expected[i];
        const double d = std::isfinite(signed_apart) ? std::abs(signed_apart) : 1e9;
        apart.push_back(d);
        found.mean += d / static_cast<double>(expected.size());
        found.bias += signed_apart / static_cast<double>(expected.size());
        const std::size_t x = i % columns, y = i / columns;
        const bool on[] = {y == 0, y + 1 == rows, x == 0, x + 1 == columns};
        for (std::size_t side = 0; side < 4; ++side)
            sides[side] += on[side] ? d / static_cast<double>(side < 2 ? columns : rows) : 0;
    }
    found.border = *std::max_element(std::begin(sides), std::end(sides));
    std::sort(apart.begin(), apart.end());
    found.typical = apart[apart.size() * 99 / 100];
    found.most = apart.back();
    return found;
}

difference compare(const std::vector<float>& shader, const visibility_image& expected) {
    return compare(shader, expected.visibility, expected.width);
}

void check_within(const difference& found, const difference& allowed) {
    CHECK(found.typical <= allowed.typical);
    CHECK(found.mean <= allowed.mean);
    CHECK(found.border <= allowed.border);
    CHECK(found.most <= allowed.most);
    CHECK(std::abs(found.bias) <= allowed.bias);
}

std::unique_ptr<crease::composition> compose(const std::string& recipe_text) {
    const crease::recipe chosen{std::string_view(recipe_text)};
    REQUIRE_MESSAGE(static_cast<bool>(chosen), chosen.error());
    return std::make_unique<crease::composition>(chosen);
}

}
