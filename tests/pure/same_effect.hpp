// SPDX-License-Identifier: MIT
// Effects composed at compile time and at run time, compared in all that they say.
#pragma once

#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace compared {

using namespace crease;

inline bool same(const binding& a, const binding& b) {
    return a.name == b.name && a.resource == b.resource && a.how == b.how && a.set == b.set &&
           a.slot == b.slot;
}

inline bool same(const constant& a, const constant& b) {
    return a.part == b.part && a.number == b.number && a.id == b.id && a.value == b.value;
}

inline bool same(const resource& a, const resource& b) {
    return a.name == b.name && a.kind == b.kind && a.texels == b.texels && a.element == b.element &&
           a.life == b.life && a.size == b.size && a.layers == b.layers && a.samples == b.samples &&
           a.arrayed == b.arrayed && a.centred == b.centred && a.read == b.read &&
           a.previous_of == b.previous_of && a.cleared == b.cleared && a.clear == b.clear && a.fill == b.fill;
}

inline bool same(const effect_setting& a, const effect_setting& b) {
    return a.part == b.part && a.name == b.name && a.fallback == b.fallback && a.least == b.least &&
           a.most == b.most && a.meaning == b.meaning && a.shared == b.shared;
}

template <class Item>
bool all_same(array_view<const Item> one, array_view<const Item> other) {
    return std::ranges::equal(one, other, [](const Item& a, const Item& b) { return same(a, b); });
}

inline void check_equal(const pass& fixed, const pass& chosen) {
    CHECK(fixed.name == chosen.name);
    CHECK(fixed.stage == chosen.stage);
    CHECK(fixed.dialect == chosen.dialect);
    CHECK(fixed.size == chosen.size);
    CHECK(fixed.covers == chosen.covers);
    CHECK(fixed.view == chosen.view);
    CHECK(all_same(fixed.bindings, chosen.bindings));
    CHECK(all_same(fixed.constants, chosen.constants));
    CHECK(joined(fixed.pieces) == joined(chosen.pieces));
    CHECK(joined(fixed.vertex_pieces) == joined(chosen.vertex_pieces));
    REQUIRE(fixed.pieces.size() == chosen.pieces.size());
    for (std::size_t i = 0; i < fixed.pieces.size(); ++i) {
        CHECK(fixed.pieces[i].name == chosen.pieces[i].name);
        CHECK(fixed.pieces[i].first_line == chosen.pieces[i].first_line);
    }
}

template <class Effect, std::size_t... Pass>
void check_sources(std::index_sequence<Pass...>) {
    const std::string_view sources[] = {Effect::template source<Pass>()...};
    for (std::size_t i = 0; i < sizeof...(Pass); ++i) {
        CHECK(joined(Effect::passes[i].pieces) == sources[i]);
        CHECK(sources[i].data()[sources[i].size()] == '\0');
    }
}

/// Checks that the effect and that of a recipe are equal to the byte.
template <class Effect>
void check_equal_to(std::string_view text, array_view<const part* const> known = all_parts) {
    CAPTURE(std::string(text));
    const recipe chosen(text, known);
    CAPTURE(std::string(chosen.error()));
    REQUIRE(chosen);
    const auto composed = std::make_unique<composition>(chosen);
    CAPTURE(std::string(composed->error()));
    REQUIRE(*composed);
    const effect_view view = composed->view();
    CHECK(view.defaults == Effect::defaults);
    CHECK(view.features == Effect::features);
    CHECK(view.views == Effect::view().views);
    CHECK(view.recipe == Effect::view().recipe);
    CHECK(all_same<resource>(Effect::resources, view.resources));
    CHECK(all_same<effect_setting>(Effect::settings, view.settings));
    REQUIRE(view.passes.size() == Effect::passes.size());
    for (std::size_t i = 0; i < view.passes.size(); ++i)
        check_equal(Effect::passes[i], view.passes[i]);
    check_sources<Effect>(std::make_index_sequence<Effect::passes.size()>{});
}

}
