// SPDX-License-Identifier: MIT
// What the C library says of a recipe, against the C++ of the same recipe.
#include "compositions.hpp"
#include "text.hpp"

#include <crease_c.h>

#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace {

struct composed {
    crease_composition* handle;
    const crease_effect* effect;

    explicit composed(const char* text) : handle(crease_compose(text)), effect(crease_effect_of(handle)) {}
    composed(const composed&) = delete;
    composed& operator=(const composed&) = delete;
    ~composed() { crease_destroy(handle); }

    std::string error() const {
        const char* sentence = crease_error(handle);
        return sentence ? sentence : "";
    }
};

bool same(const crease_extent& c, const crease::extent& cpp) {
    return c.divisor == cpp.divisor && (c.guarded != 0) == cpp.guarded && c.fixed_width == cpp.fixed_width &&
           c.fixed_height == cpp.fixed_height && c.level == cpp.level;
}

void check_same(const crease_pass& c, const crease::pass& cpp) {
    CHECK(c.name == cpp.name);
    CHECK(static_cast<int>(c.stage) == static_cast<int>(cpp.stage));
    CHECK(static_cast<int>(c.dialect) == static_cast<int>(cpp.dialect));
    CHECK(static_cast<int>(c.dispatch) == static_cast<int>(cpp.covers));
    CHECK((c.text == joined(cpp.pieces)));
    CHECK((c.vertex_text != nullptr) == !cpp.vertex_pieces.empty());
    if (c.vertex_text)
        CHECK((c.vertex_text == joined(cpp.vertex_pieces)));
    CHECK(same(c.size, cpp.size));
    CHECK(c.group_width == cpp.group_width());
    CHECK(c.group_height == cpp.group_height());
    CHECK(c.view == cpp.view);
    REQUIRE(c.binding_count == cpp.bindings.size());
    for (std::uint32_t i = 0; i < c.binding_count; ++i) {
        CHECK(c.bindings[i]->name == cpp.bindings[i].name);
        CHECK(c.bindings[i]->resource == cpp.bindings[i].resource);
        CHECK(static_cast<int>(c.bindings[i]->access) == static_cast<int>(cpp.bindings[i].how));
        CHECK(c.bindings[i]->set == cpp.bindings[i].set);
        CHECK(c.bindings[i]->slot == cpp.bindings[i].slot);
        CHECK(c.bindings[i]->level == cpp.bindings[i].level);
    }
    REQUIRE(c.constant_count == cpp.constants.size());
    for (std::uint32_t i = 0; i < c.constant_count; ++i) {
        CHECK(c.constants[i]->part == cpp.constants[i].part);
        CHECK(c.constants[i]->number == cpp.constants[i].number);
        CHECK(c.constants[i]->id == cpp.constants[i].id);
        CHECK(c.constants[i]->value == cpp.constants[i].value);
    }
}

void check_same(const crease_resource& c, const crease::resource& cpp) {
    CHECK(c.name == cpp.name);
    CHECK(static_cast<int>(c.kind) == static_cast<int>(cpp.kind));
    CHECK(static_cast<int>(c.format) == static_cast<int>(cpp.texels));
    CHECK(c.element == cpp.element);
    CHECK(static_cast<int>(c.lifetime) == static_cast<int>(cpp.life));
    CHECK(same(c.size, cpp.size));
    CHECK(c.meaning == cpp.meaning);
    CHECK(c.layers == cpp.layers);
    CHECK(c.levels == cpp.levels);
    CHECK(c.samples == cpp.samples);
    CHECK((c.arrayed != 0) == cpp.arrayed);
    CHECK((c.centred != 0) == cpp.centred);
    CHECK(c.previous_of == cpp.previous_of);
    CHECK((c.cleared != 0) == cpp.cleared);
    CHECK(c.clear == cpp.clear);
    CHECK(std::string_view(c.content) == cpp.content);
    if (cpp.fill) {
        std::vector<std::uint32_t> texels(c.texel_count);
        REQUIRE(c.texel_count == cpp.size.fixed_width * cpp.size.fixed_height);
        cpp.fill({texels.data(), texels.size()});
        CHECK(std::equal(texels.begin(), texels.end(), c.texels));
    } else {
        CHECK(c.texels == nullptr);
        CHECK(c.texel_count == 0);
    }
}

void check_same(const crease_setting& c, const crease::effect_setting& cpp) {
    CHECK(c.part == cpp.part);
    CHECK(c.name == cpp.name);
    CHECK(c.meaning == cpp.meaning);
    CHECK(c.fallback == cpp.fallback);
    CHECK(c.least == cpp.least);
    CHECK(c.most == cpp.most);
    CHECK((c.shared != 0) == cpp.shared);
}

void check_same(const crease_effect& c, const crease::effect_view& cpp) {
    CHECK(c.recipe == cpp.recipe);
    CHECK(c.view_count == cpp.views);
    CHECK(c.block_size == cpp.block_size());
    CHECK(c.radius_offset == crease::radius_offset(cpp.views));
    CHECK(c.frame_offset == c.radius_offset + 4);
    CHECK(c.from_first_offset == 48 * cpp.views);
    REQUIRE(c.pass_count == cpp.passes.size());
    for (std::uint32_t i = 0; i < c.pass_count; ++i)
        check_same(*c.passes[i], cpp.passes[i]);
    REQUIRE(c.resource_count == cpp.resources.size());
    for (std::uint32_t i = 0; i < c.resource_count; ++i)
        check_same(*c.resources[i], cpp.resources[i]);
    REQUIRE(c.setting_count == cpp.settings.size());
    for (std::uint32_t i = 0; i < c.setting_count; ++i) {
        check_same(*c.settings[i], cpp.settings[i]);
        CHECK(c.settings[i]->offset == crease::setting_offset(cpp.views, i));
    }
    CHECK((c.features.extended_storage_formats != 0) == cpp.features.extended_storage_formats);
    CHECK((c.features.fragment_stores_and_atomics != 0) == cpp.features.fragment_stores_and_atomics);
    CHECK((c.features.subgroup_arithmetic != 0) == cpp.features.subgroup_arithmetic);
    CHECK(c.features.depth_samples == cpp.features.depth_samples);
    CHECK(c.features.centred_depth_samples == cpp.features.centred_depth_samples);
}

/// The presets, and of all compositions those in which a part stands for the first time.
std::vector<std::string> choice_of_recipes() {
    std::vector<std::string> recipes = first_of_each(every_recipe());
    for (const crease::preset_description* preset : crease::all_presets)
        recipes.push_back("preset:" + std::string(preset->name));
    return recipes;
}

}

TEST_CASE("a recipe gives what it gives in C++, byte for byte") {
    const std::vector<std::string> recipes = choice_of_recipes();
    REQUIRE(recipes.size() > 50);
    for (const std::string& text : recipes) {
        CAPTURE(text);
        const composed c(text.c_str());
        REQUIRE(c.error() == "");
        REQUIRE(c.effect);
        const auto cpp = std::make_unique<crease::composition>(crease::recipe(std::string_view(text)));
        check_same(*c.effect, cpp->view());
    }
}

TEST_CASE("parts of an effect: those that are named, and those by default") {
    const composed c("directions:2x3/single_layer/hbao/bilateral");
    REQUIRE(c.effect);
    std::vector<std::string> named, others;
    for (std::uint32_t i = 0; i < c.effect->part_count; ++i) {
        const crease_choice& each = *c.effect->parts[i];
        (each.named ? named : others).push_back(std::string(each.part->role) + " " + each.part->name);
    }
    CHECK(named == std::vector<std::string>{"sampler directions", "depth source single_layer",
                                            "estimator hbao", "filter bilateral"});
    CHECK(std::ranges::find(others, "projection perspective") != others.end());
    CHECK(c.effect->parts[0]->numbers[0] == 2);
    CHECK(c.effect->parts[0]->numbers[1] == 3);
}

TEST_CASE("what makes no effect is refused in the sentence of C++") {
    for (const char* text :
         {"", "/", "directions", "hbao/single_layer/directions", "directions/single_layer/nobody",
          "directions:8x/single_layer/hbao", "directions:0x1/single_layer/hbao",
          "directions:1x2x3x4x5x6/single_layer/hbao", "directions:8x4/single_layer/ssao", "preset:nobody",
          "directions/single_layer/hbao/second_view", "\xff/\x01/\n"}) {
        CAPTURE(std::string(text));
        const composed c(text);
        const auto cpp = std::make_unique<crease::composition>(crease::recipe(std::string_view(text)));
        CHECK(c.effect == nullptr);
        CHECK(c.error() != "");
        CHECK(c.error() == cpp->error());
        char sentence[512];
        CHECK(crease_check(text, sentence, sizeof sentence) == c.error().size());
        CHECK(sentence == c.error());
    }
}

TEST_CASE("what is too large is refused as it is composed") {
    std::string text = "directions/single_layer/hbao/upsample/bilateral";
    for (int i = 0; i < 8; ++i)
        text += "/bilateral";
    const composed c(text.c_str());
    const auto cpp = std::make_unique<crease::composition>(crease::recipe(std::string_view(text)));
    CHECK(crease_check(text.c_str(), nullptr, 0) == 0);
    CHECK(c.effect == nullptr);
    CHECK(c.error() != "");
    CHECK(c.error() == cpp->error());
}

TEST_CASE("a sentence is cut to the room that there is") {
    char sentence[8] = "unused";
    CHECK(crease_check("nobody", nullptr, 0) > 8);
    CHECK(crease_check("nobody", sentence, sizeof sentence) > 8);
    CHECK(std::string(sentence) == "crease:");
    CHECK(crease_check("directions/single_layer/hbao", sentence, sizeof sentence) == 0);
    CHECK(std::string(sentence) == "");
}

TEST_CASE("NULL is an error") {
    CHECK(std::string(crease_error(nullptr)) ==
          "crease_c: the composition is NULL: memory ran out, or none was composed");
    CHECK(crease_effect_of(nullptr) == nullptr);
    crease_destroy(nullptr);
    const composed none(nullptr);
    CHECK(none.error() == "crease_c: the recipe is NULL");
    CHECK(none.effect == nullptr);
    CHECK(crease_check(nullptr, nullptr, 10) == none.error().size());
}

TEST_CASE("the library says which version it is") {
    CHECK(crease_c_version() == CREASE_VERSION);
    CHECK(crease_c_version_text() == crease::version);
}
