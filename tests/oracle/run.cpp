// SPDX-License-Identifier: MIT
#include "run.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

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

std::vector<float> run(const picture& p, const crease::effect_view& effect, const crease::parameters& how) {
    crease::vulkan::runner runner(device(), effect, static_cast<unsigned>(p.width),
                                  static_cast<unsigned>(p.height));
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
    runner.run(how);
    return runner.download("visibility");
}

std::vector<float> run(const picture& p, const std::string& recipe_text, double radius) {
    const crease::recipe chosen{std::string_view(recipe_text)};
    const auto composed = std::make_unique<crease::composition>(chosen);
    return run(p, composed->view(), view_parameters(p, composed->view(), radius));
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
