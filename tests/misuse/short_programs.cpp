// crease::effect: a program has 500 names, 190 functions and 6000 characters of interface at the most
// (hbao, long_noise)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

// Noise of more constants than a file may define.
struct long_noise {
    static constexpr crease::glsl_file glsl{"host/noise.glsl",
                                            "const int crease_long_noise_0 = 0;\n"
                                            "const int crease_long_noise_1 = 1;\n"
                                            "const int crease_long_noise_2 = 2;\n"
                                            "const int crease_long_noise_3 = 3;\n"
                                            "const int crease_long_noise_4 = 4;\n"
                                            "const int crease_long_noise_5 = 5;\n"
                                            "const int crease_long_noise_6 = 6;\n"
                                            "const int crease_long_noise_7 = 7;\n"
                                            "const int crease_long_noise_8 = 8;\n"
                                            "const int crease_long_noise_9 = 9;\n"
                                            "const int crease_long_noise_10 = 10;\n"
                                            "const int crease_long_noise_11 = 11;\n"
                                            "const int crease_long_noise_12 = 12;\n"
                                            "const int crease_long_noise_13 = 13;\n"
                                            "const int crease_long_noise_14 = 14;\n"
                                            "const int crease_long_noise_15 = 15;\n"
                                            "const int crease_long_noise_16 = 16;\n"
                                            "const int crease_long_noise_17 = 17;\n"
                                            "const int crease_long_noise_18 = 18;\n"
                                            "const int crease_long_noise_19 = 19;\n"
                                            "const int crease_long_noise_20 = 20;\n"
                                            "const int crease_long_noise_21 = 21;\n"
                                            "const int crease_long_noise_22 = 22;\n"
                                            "const int crease_long_noise_23 = 23;\n"
                                            "const int crease_long_noise_24 = 24;\n"
                                            "const int crease_long_noise_25 = 25;\n"
                                            "const int crease_long_noise_26 = 26;\n"
                                            "const int crease_long_noise_27 = 27;\n"
                                            "const int crease_long_noise_28 = 28;\n"
                                            "const int crease_long_noise_29 = 29;\n"
                                            "const int crease_long_noise_30 = 30;\n"
                                            "const int crease_long_noise_31 = 31;\n"
                                            "const int crease_long_noise_32 = 32;\n"
                                            "const int crease_long_noise_33 = 33;\n"
                                            "const int crease_long_noise_34 = 34;\n"
                                            "const int crease_long_noise_35 = 35;\n"
                                            "const int crease_long_noise_36 = 36;\n"
                                            "const int crease_long_noise_37 = 37;\n"
                                            "const int crease_long_noise_38 = 38;\n"
                                            "const int crease_long_noise_39 = 39;\n"
                                            "vec3 crease_noise(ivec2 pixel) { return vec3(0.5); }\n"};
    static constexpr const crease::glsl_file* files[] = {&glsl};
    static constexpr crease::part description{
        .kind = crease::role::noise, .name = "long_noise", .summary = "", .source = "", .files = files};
};

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, long_noise>::passes.size();
