// SPDX-License-Identifier: MIT
#include <crease/effect/format.hpp>

#include <doctest/doctest.h>

#include <initializer_list>

using namespace crease;

TEST_CASE("what GLSL and a device know of each format") {
    struct expectation {
        format texels;
        std::string_view name, glsl;
        bool whole_numbers, extended;
    };
    // shaderStorageImageExtendedFormats is about all but r32, rgba8, rgba16f and rgba32.
    for (const expectation& each : {expectation{format::none, "none", "", false, false},
                                    {format::r8_unorm, "r8_unorm", "r8", false, true},
                                    {format::rgba8_unorm, "rgba8_unorm", "rgba8", false, false},
                                    {format::r32_uint, "r32_uint", "r32ui", true, false},
                                    {format::rg32_uint, "rg32_uint", "rg32ui", true, true},
                                    {format::rgba32_uint, "rgba32_uint", "rgba32ui", true, false},
                                    {format::r32_float, "r32_float", "r32f", false, false},
                                    {format::rg32_float, "rg32_float", "rg32f", false, true},
                                    {format::rgba16_float, "rgba16_float", "rgba16f", false, false},
                                    {format::rgba32_float, "rgba32_float", "rgba32f", false, false},
                                    {format::d32_float, "d32_float", "", false, false}}) {
        const format_facts& facts = facts_of(each.texels);
        CHECK(facts.name == each.name);
        CHECK(facts.glsl == each.glsl);
        CHECK(facts.whole_numbers == each.whole_numbers);
        CHECK(facts.extended == each.extended);
    }
}
