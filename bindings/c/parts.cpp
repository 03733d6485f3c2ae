// SPDX-License-Identifier: MIT
#include "parts.hpp"

#include <crease/parts/all_parts.hpp>
#include <crease/parts/presets.hpp>

#include <array>
#include <cstddef>
#include <iterator>

namespace crease::c {

namespace {

constexpr std::size_t part_count = std::size(all_parts), preset_count = std::size(all_presets);

/// A literal as C has it; what ends with no NUL does not compile.
constexpr const char* literal(std::string_view text) {
    if (!text.empty() && text.data()[text.size()] != '\0')
        throw "not a literal";
    return text.empty() ? "" : text.data();
}

/// What `list_of` gives of each part, one after the other: C objects, and pointers to them.
template <class Item, auto ListOf, auto Convert>
struct lists {
    static constexpr std::size_t count = [] {
        std::size_t sum = 0;
        for (const part* p : all_parts)
            sum += ListOf(*p).size();
        return sum;
    }();
    static constexpr std::array<Item, count> items = [] {
        std::array<Item, count> all{};
        std::size_t next = 0;
        for (const part* p : all_parts)
            for (const auto& each : ListOf(*p))
                all[next++] = Convert(*p, each);
        return all;
    }();
    static constexpr std::array<const Item*, count> pointers = [] {
        std::array<const Item*, count> all{};
        for (std::size_t i = 0; i < count; ++i)
            all[i] = &items[i];
        return all;
    }();
    static constexpr std::array<std::size_t, part_count> begins = [] {
        std::array<std::size_t, part_count> all{};
        std::size_t sum = 0;
        for (std::size_t i = 0; i < part_count; ++i) {
            all[i] = sum;
            sum += ListOf(*all_parts[i]).size();
        }
        return all;
    }();
};

using numbers =
    lists<crease_number, [](const part& p) { return p.numbers; },
          [](const part&, const number& n) {
              return crease_number{literal(n.name), literal(n.meaning), n.least, n.most, n.fallback};
          }>;
using settings = lists<crease_setting, [](const part& p) { return p.settings; },
                       [](const part& p, const setting& s) {
                           return described(s, literal(p.name), literal(s.name), literal(s.meaning), 0);
                       }>;

constexpr std::array<crease_part, part_count> parts = [] {
    std::array<crease_part, part_count> all{};
    for (std::size_t i = 0; i < part_count; ++i) {
        const part& p = *all_parts[i];
        all[i] = {literal(p.name),
                  literal(name_of(p.kind)),
                  literal(p.summary),
                  literal(p.source),
                  numbers::pointers.data() + numbers::begins[i],
                  settings::pointers.data() + settings::begins[i],
                  static_cast<std::uint32_t>(p.numbers.size()),
                  static_cast<std::uint32_t>(p.settings.size())};
    }
    return all;
}();

constexpr std::array<fixed_text<512>, preset_count> preset_recipes = [] {
    std::array<fixed_text<512>, preset_count> all{};
    for (std::size_t i = 0; i < preset_count; ++i)
        all[i] = recipe_text(all_presets[i]->parts);
    return all;
}();

constexpr std::array<crease_preset, preset_count> presets = [] {
    std::array<crease_preset, preset_count> all{};
    for (std::size_t i = 0; i < preset_count; ++i)
        all[i] = {literal(all_presets[i]->name), literal(all_presets[i]->summary),
                  literal(preset_recipes[i].view())};
    return all;
}();

}

const crease_part* part_of(const part* which) {
    for (std::size_t i = 0; i < part_count; ++i)
        if (all_parts[i] == which)
            return &parts[i];
    return nullptr;
}

}

std::uint32_t crease_part_count() {
    return crease::c::part_count;
}

const crease_part* crease_part_at(std::uint32_t index) {
    return index < crease::c::part_count ? &crease::c::parts[index] : nullptr;
}

std::uint32_t crease_preset_count() {
    return crease::c::preset_count;
}

const crease_preset* crease_preset_at(std::uint32_t index) {
    return index < crease::c::preset_count ? &crease::c::presets[index] : nullptr;
}
