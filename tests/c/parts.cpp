// SPDX-License-Identifier: MIT
#include <crease_c.h>

#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <iterator>
#include <string>

TEST_CASE("the parts, with roles, numbers and settings") {
    REQUIRE(crease_part_count() == std::size(crease::all_parts));
    for (std::uint32_t i = 0; i < crease_part_count(); ++i) {
        const crease_part& c = *crease_part_at(i);
        const crease::part& cpp = *crease::all_parts[i];
        CAPTURE(std::string(c.name));
        CHECK(c.name == cpp.name);
        CHECK(c.role == crease::name_of(cpp.kind));
        CHECK(c.summary == cpp.summary);
        CHECK(c.source == cpp.source);
        REQUIRE(c.number_count == cpp.numbers.size());
        for (std::uint32_t n = 0; n < c.number_count; ++n) {
            CHECK(c.numbers[n]->name == cpp.numbers[n].name);
            CHECK(c.numbers[n]->meaning == cpp.numbers[n].meaning);
            CHECK(c.numbers[n]->least == cpp.numbers[n].least);
            CHECK(c.numbers[n]->most == cpp.numbers[n].most);
            CHECK(c.numbers[n]->fallback == cpp.numbers[n].fallback);
        }
        REQUIRE(c.setting_count == cpp.settings.size());
        for (std::uint32_t s = 0; s < c.setting_count; ++s) {
            CHECK(c.settings[s]->part == cpp.name);
            CHECK(c.settings[s]->name == cpp.settings[s].name);
            CHECK(c.settings[s]->meaning == cpp.settings[s].meaning);
            CHECK(c.settings[s]->fallback == cpp.settings[s].fallback);
            CHECK(c.settings[s]->least == cpp.settings[s].least);
            CHECK(c.settings[s]->most == cpp.settings[s].most);
            CHECK((c.settings[s]->shared != 0) == cpp.settings[s].shared);
        }
    }
    CHECK(crease_part_at(crease_part_count()) == nullptr);
    CHECK(crease_part_at(0xffffffffu) == nullptr);
}

TEST_CASE("the presets, whose recipes can be composed") {
    REQUIRE(crease_preset_count() == std::size(crease::all_presets));
    for (std::uint32_t i = 0; i < crease_preset_count(); ++i) {
        const crease_preset& c = *crease_preset_at(i);
        CHECK(c.name == crease::all_presets[i]->name);
        CHECK(c.summary == crease::all_presets[i]->summary);
        CHECK(c.recipe == crease::recipe("preset:" + std::string(c.name)).text().view());
        CHECK(crease_check(c.recipe, nullptr, 0) == 0);
    }
    CHECK(crease_preset_at(crease_preset_count()) == nullptr);
}
