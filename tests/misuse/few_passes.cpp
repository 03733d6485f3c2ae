// crease::effect: an effect has 32 passes at the most, each with 8 outputs, 16 bindings and 32 constants
// (hbao, noise_image)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

// Noise that a first pass should make.
struct noise_image {
    static constexpr crease::glsl_file make{
        "host/make.glsl", "void crease_build(ivec2 texel) { imageStore(crease_numbers, texel, "
                          "vec4(0.5)); }\n"};
    static constexpr crease::glsl_file read{
        "host/read.glsl", "vec3 crease_noise(ivec2 pixel) { return crease_load_numbers(pixel).xyz; }\n"};
    static constexpr const crease::glsl_file *making[] = {&make}, *files[] = {&read};
    static constexpr crease::resource images[] = {
        {.name = "numbers", .texels = crease::format::rgba32_float, .life = crease::lifetime::transient}};
    static constexpr std::string_view filled[] = {"numbers"};
    static constexpr crease::step steps[] = {
        {.name = "make", .files = making, .kind = crease::step_kind::texels, .writes = filled, .times = 32}};
    static constexpr crease::part description{.kind = crease::role::noise,
                                              .name = "noise_image",
                                              .summary = "",
                                              .source = "",
                                              .files = files,
                                              .resources = images,
                                              .steps = steps};
};

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, noise_image>::passes.size();
