// SPDX-License-Identifier: MIT
// An estimator of an engine's own, in two files, beside the parts of crease.
#include "openness.hpp"

#include <algorithm>
#include <exception>
#include <iostream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#ifdef OWN_ESTIMATORS_WITH_SPIRV
#include <crease/spirv.hpp>
#endif
#ifdef OWN_ESTIMATORS_WITH_VULKAN
#include "corner.hpp"

#include <crease/vulkan.hpp>
#endif

namespace {

using plain = crease::effect<crease::directions<4, 4>, crease::single_layer, engine::openness,
                             crease::reconstructed_normals>;
using layered = crease::effect<crease::directions<4, 4>, crease::stochastic_layers<8>, engine::openness,
                               crease::front_first<>, crease::bent_cone>;

// A setting that no part of crease knows goes into the block of parameters like any other.
static_assert(crease::get(plain::defaults, plain::settings, "openness.reach") == 0.5f);

/// The bias by its name, which the effect checks at compile time.
crease::parameters of_bias(float sine) {
    crease::parameters values = plain::defaults;
    if (!plain::set<"bias">(values, sine))
        throw std::runtime_error("a bias that is out of its range");
    return values;
}

/// By a name that is known at run time only.
void expect_settings_by_name(const crease::effect_view& effect) {
    crease::parameters values = effect.defaults;
    if (!crease::set(values, effect.settings, "openness.bias", 0.1f) || values != of_bias(0.1f))
        throw std::runtime_error("the bias is not set by its name");
    if (crease::set(values, effect.settings, "bias", -1) || values != of_bias(0.1f))
        throw std::runtime_error("a bias that is out of its range is set");
}

/// A recipe may name the parts that it is told of, and makes the same programs.
void expect_same(const crease::effect_view& effect, std::string_view text) {
    std::vector<const crease::part*> known(std::begin(crease::all_parts), std::end(crease::all_parts));
    known.push_back(&engine::openness::description);
    const crease::recipe recipe(text, known);
    if (!recipe)
        throw std::runtime_error(std::string(recipe.error()));
    const auto composed = std::make_unique<crease::composition>(recipe);
    const auto same_text = [](const crease::pass& one, const crease::pass& other) {
        return std::ranges::equal(one.pieces, other.pieces, {}, &crease::piece::text, &crease::piece::text);
    };
    if (!std::ranges::equal(effect.passes, composed->view().passes, same_text))
        throw std::runtime_error("the recipe " + std::string(text) + " and the effect differ");
}

#ifdef OWN_ESTIMATORS_WITH_SPIRV
/// An error names engine/openness.glsl and the line in it.
void compile(const crease::effect_view& effect) {
    for (const crease::pass& pass : effect.passes) {
        if (pass.stage == crease::stage_kind::geometry) // compiled with the shaders of the host that draws
            continue;
        const crease::spirv::words module = crease::spirv::compile(pass);
        crease::spirv::validate(module);
        std::cout << pass.name << ": " << module.size() << " words of valid SPIR-V\n";
    }
}
#endif

#ifdef OWN_ESTIMATORS_WITH_VULKAN
// Vulkan's own clip space: y down, so row 0 is the highest; depth reversed, the far plane at infinity.
constexpr picture::matrix projection = {1, 0, 0, 0, 0, -16.f / 9, 0, 0, 0, 0, 0, -1, 0, 0, 0.1f, 0};

std::vector<std::uint8_t> render(crease::vulkan::device& device, const crease::effect_view& effect,
                                 crease::parameters values) {
    constexpr crease::matrix_convention clip{.depth_zero_to_one = true};
    if (const auto fit =
            crease::set_projection(values.view, projection, picture::width, picture::height, clip);
        !fit)
        throw std::runtime_error(std::string(fit.error));
    values.radius = corner::radius;
    crease::vulkan::runner runner(device, effect, picture::width, picture::height);
    runner.upload("depth", corner::device_depth(projection, clip));
    runner.run(values);
    std::vector<std::uint8_t> visibility;
    for (float share : runner.download("visibility"))
        visibility.push_back(static_cast<std::uint8_t>(255 * share + 0.5f));
    return visibility;
}

float mean(const std::vector<std::uint8_t>& visibility) {
    double sum = 0;
    for (std::uint8_t each : visibility)
        sum += each;
    return static_cast<float>(sum / (255 * static_cast<double>(visibility.size())));
}

bool plausible(crease::vulkan::device& device) {
    const bool near = corner::plausible(render(device, plain::view(), plain::defaults), projection);
    const float low = mean(render(device, plain::view(), of_bias(0))),
                high = mean(render(device, plain::view(), of_bias(0.5f)));
    std::cout << "mean visibility without a bias " << low << ", with one of a half " << high << '\n';
    return near && low < high;
}
#endif

}

int main() {
    try {
        expect_same(plain::view(), "directions:4x4/single_layer/openness/reconstructed_normals");
        expect_same(layered::view(), "directions:4x4/stochastic_layers:8/openness/front_first/bent_cone");
        expect_settings_by_name(plain::view());
#ifdef OWN_ESTIMATORS_WITH_SPIRV
        for (const crease::effect_view& effect : {plain::view(), layered::view()})
            compile(effect);
#endif
#ifdef OWN_ESTIMATORS_WITH_VULKAN
        crease::vulkan::device device;
        return plausible(device) ? 0 : 1;
#endif
    } catch (const std::exception& failure) {
        std::cerr << "own_estimators: " << failure.what() << '\n';
        return 1;
    }
}
