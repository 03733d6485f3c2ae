// SPDX-License-Identifier: MIT
#include <crease/resource.hpp>

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("a size follows the picture, divided and rounded up on each axis") {
    constexpr extent whole{}, half{.divisor = 2}, sixth{.divisor = 6};
    CHECK(whole.width_of(641) == 641);
    CHECK(whole.height_of(359) == 359);
    CHECK(half.width_of(641) == 321);
    CHECK(half.height_of(359) == 180);
    CHECK(half.width_of(640) == 320);
    CHECK(sixth.width_of(641) == 107);
    CHECK(sixth.height_of(359) == 60);
    CHECK(sixth.width_of(1) == 1);
    CHECK(sixth.height_of(6) == 1);
    CHECK(sixth.height_of(7) == 2);
}

TEST_CASE("a guard band lies on both sides, in the texels of the image, and only where it is asked for") {
    constexpr extent guarded{.guarded = true}, smaller{.divisor = 4, .guarded = true}, bare{.divisor = 4};
    CHECK(guarded.width_of(641, 16) == 673);
    CHECK(guarded.height_of(359, 16) == 391);
    CHECK(guarded.width_of(641) == 641);
    CHECK(smaller.width_of(641, 16) == 193);
    CHECK(smaller.height_of(359, 16) == 122);
    CHECK(bare.width_of(641, 16) == 161);
    CHECK(bare.height_of(359, 16) == 90);
}

TEST_CASE("a fixed side stays, whatever the picture and the band; the other follows") {
    constexpr extent row{.fixed_height = 1}, column{.fixed_width = 3},
        table{.fixed_width = 256, .fixed_height = 257};
    CHECK(row.width_of(641, 16) == 641);
    CHECK(row.height_of(359, 16) == 1);
    CHECK(column.width_of(641, 16) == 3);
    CHECK(column.height_of(359, 16) == 359);
    CHECK(table.width_of(641, 16) == 256);
    CHECK(table.height_of(359, 16) == 257);
}

TEST_CASE("which accesses write, and which have a descriptor") {
    struct expectation {
        access how;
        bool writes, descriptor;
    };
    for (const expectation& each : {expectation{access::uniform, false, true},
                                    {access::sample, false, true},
                                    {access::load, false, true},
                                    {access::store, true, true},
                                    {access::modify, true, true},
                                    {access::attachment, true, false},
                                    {access::result, true, false}}) {
        CAPTURE(static_cast<int>(each.how));
        CHECK(writes(each.how) == each.writes);
        CHECK(has_descriptor(each.how) == each.descriptor);
    }
}

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
