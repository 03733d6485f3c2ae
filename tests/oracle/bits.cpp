// SPDX-License-Identifier: MIT
// What GLSL ES 3.00 counts bits by, run in Vulkan.
#include "run.hpp"

#include <doctest/doctest.h>

namespace {

/// The default noise, and with it what stands in the place of `bitCount` where GLSL has none.
struct counting {
    static constexpr const crease::glsl_file* files[] = {&crease::hashed_noise_glsl,
                                                         &crease::glsl_es_300_glsl};
    static constexpr crease::part description{.kind = crease::role::noise,
                                              .name = "counting",
                                              .summary = "hashed noise, and bits counted by sums",
                                              .source = "",
                                              .files = files};
};

}

TEST_CASE("GLSL ES 3.00 counts bits as bitCount does") {
    using namespace crease;
    const oracle::picture p = oracle::draw(oracle::still_life(), oracle::lens::standard, 97, 61);
    using usual = effect<slices<>, single_layer, visibility_bitmask>;
    using by_sums = effect<slices<>, single_layer, visibility_bitmask, counting>;
    const parameters how = oracle::view_parameters(p, usual::view(), 0.5);
    REQUIRE(usual::source<0>().find("return bitCount(int(bits));") != std::string_view::npos);
    REQUIRE(by_sums::source<0>().find("bitCount") == std::string_view::npos);
    CHECK(oracle::run(p, usual::view(), how) == oracle::run(p, by_sums::view(), how));
}
