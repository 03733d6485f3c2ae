// SPDX-License-Identifier: MIT
#include "run.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
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
    crease::set_projection(how.view, matrix, static_cast<unsigned>(p.width), static_cast<unsigned>(p.height));
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

settings settings_of(const crease::parameters& how) {
    return {.radius = how.radius,
            .bias = how.bias,
            .threshold = how.threshold,
            .strength = how.strength,
            .exponent = how.exponent,
            .sharpness = how.sharpness,
            .falloff = how.falloff,
            .frame = how.frame};
}

difference compare(const std::vector<float>& shader, const std::vector<double>& expected) {
    std::vector<double> apart;
    double sum = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const double d = std::abs(shader.at(i) - expected[i]);
        apart.push_back(std::isfinite(d) ? d : 1e9);
        sum += apart.back();
    }
    std::sort(apart.begin(), apart.end());
    return {apart[apart.size() * 99 / 100], sum / static_cast<double>(apart.size())};
}

}
