// SPDX-License-Identifier: MIT
#pragma once

#include "effect.hpp"

#include <crease/crease.hpp>
#include <crease/vulkan.hpp>

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace oracle {

/// The device of all tests, with validation: any message of the layers fails the test that caused it.
crease::vulkan::device& device();

/// Parameters for a picture, with an effect's defaults.
crease::parameters view_parameters(const picture& p, const crease::effect_view& effect, double radius);

/// The effect of a recipe, and what runs it on pictures of one size.
struct prepared {
    crease::composition composed;
    crease::vulkan::runner runner;

    prepared(const crease::recipe& of, const picture& p, const std::map<std::string, int>& constants);
};

/// The same object for the same arguments, until many others have been asked for, as a driver takes longer to
/// compile an effect than to run it on a small picture.
prepared& prepare(const std::string& recipe_text, const picture& p,
                  const std::map<std::string, int>& constants = {});

/// Fills the inputs of an effect that are in a picture.
void upload(crease::vulkan::runner& runner, const crease::effect_view& effect, const picture& p);

/// The image, else the visibility, that an effect gives for a picture, row by row.
std::vector<float> run(const picture& p, const crease::effect_view& effect, const crease::parameters& how,
                       std::string_view image = "visibility");

/// The same for a recipe; its defaults and this radius.
std::vector<float> run(const picture& p, const std::string& recipe_text, double radius);

/// Sets a setting of an effect, e.g. "bias"; one that it lacks, or a value out of its range, fails the test.
void set(crease::parameters& how, const crease::effect_view& effect, std::string_view name, double value);

/// The settings that the oracle needs, out of the parameters of an effect.
settings settings_of(const crease::parameters& how, const crease::effect_view& effect);

/// The oracle's picture of a main pass, at 1 / `divisor` of the size of `p`.
template <class Occlusion>
visibility_image main_pass(const picture& p, const settings& s, int divisor, bool reconstructed,
                           Occlusion occlusion) {
    visibility_image out{(p.width + divisor - 1) / divisor, (p.height + divisor - 1) / divisor, {}, {}, {}};
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int tx = std::min(x * divisor + (divisor - 1) / 2, p.width - 1);
            const int ty = std::min(y * divisor + (divisor - 1) / 2, p.height - 1);
            if (p.background(tx, ty)) {
                out.visibility.push_back(1);
                out.depth.push_back(1e9);
                out.normals.push_back({0, 0, 1});
                continue;
            }
            receiver r{tx, ty, x, y, p.position(tx, ty), glm::dvec3(p.normals[p.index(tx, ty)]), {}};
            r.to_eye = p.to_eye(r.position);
            if (reconstructed)
                r.normal = reconstruct_normal(p, tx, ty);
            out.visibility.push_back(
                std::pow(std::clamp(1 - s.strength * occlusion(r), 0.0, 1.0), s.exponent));
            out.depth.push_back(-r.position.z);
            out.normals.push_back(r.normal);
        }
    return out;
}

/// How a shader's picture differs from the oracle's: the greatest that a test allows, or what it finds.
struct difference {
    double typical = 0; ///< 99 % of the pixels differ by no more
    double mean = 0;
    double border = 0; ///< the mean over the worst of the four outermost rows and columns
    double most = 0;   ///< at the worst pixel
    double bias = 0;   ///< the mean of shader less oracle; allowed either way
};

difference compare(const std::vector<float>& shader, const std::vector<double>& expected, int width);
difference compare(const std::vector<float>& shader, const visibility_image& expected);

/// Checks each number of a difference against what a test allows.
void check_within(const difference& found, const difference& allowed);

/// What 8 bits of visibility and single precision leave, which picks the next texel for a few taps. At most
/// four times what was measured.
inline constexpr difference of_rounding{
    .typical = 0.004, .mean = 0.0007, .border = 0.0012, .most = 0.3, .bias = 0.0006};

/// The effect of a recipe; a recipe that makes none fails the test.
std::unique_ptr<crease::composition> compose(const std::string& recipe_text);

}
