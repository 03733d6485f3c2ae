// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/plan.hpp>
#include <crease/compose/preset.hpp>
#include <crease/parts/all_parts.hpp>
#include <crease/parts/presets.hpp>

#include <string_view>

namespace crease {

/// The parts of an effect chosen at run time, from text or from values, or the reason why they make none.
///
/// The text is `SAMPLER/DEPTH/ESTIMATOR` and then `/PART` for each filter, in the order in which they run,
/// and for each other part that is not the default. A part is its name and, where it takes numbers,
/// `:NxN...`; without them it has its defaults: `directions:8x4/single_layer/hbao/bilateral`. In place of the
/// three may stand a preset, `preset:NAME[/PART...]`: the parts behind it take the place of those of the
/// preset that have the same role, filters of all its filters.
class recipe {
public:
    /// The same choices as values, in the same order.
    constexpr recipe(array_view<const choice> choices) {
        for (const choice& c : choices)
            if (!choices_.full())
                choices_.add(c);
        conclude();
    }

    /// From text. `known` and `presets` are what it may name: a host adds its own to `all_parts` and
    /// `all_presets`.
    constexpr recipe(std::string_view text, array_view<const part* const> known = all_parts,
                     array_view<const preset_description* const> presets = all_presets) {
        const preset_description* preset = nullptr;
        for (bool first = true; error_.count == 0; first = false) {
            const std::size_t slash = text.find('/');
            const std::string_view word = text.substr(0, slash);
            if (first && word.starts_with(preset_prefix))
                preset = find_preset(word.substr(preset_prefix.size()), presets);
            else
                read_part(word, known);
            if (slash == std::string_view::npos)
                break;
            text.remove_prefix(slash + 1);
        }
        if (preset)
            choices_ = combine(preset->parts, choices_);
        conclude();
    }

    /// Whether the parts make an effect.
    constexpr explicit operator bool() const { return error_.count == 0; }

    /// One sentence that says why not; empty where they do. The same as the static assertion of `effect`.
    constexpr std::string_view error() const { return error_.view(); }

    /// The parts with their numbers, in the order of the text; they live as long as the recipe.
    constexpr array_view<const choice> choices() const { return choices_; }

    /// The recipe as text, with all numbers.
    constexpr fixed_text<512> text() const { return recipe_text(choices_); }

private:
    static constexpr std::string_view preset_prefix = "preset:";

    constexpr const preset_description* find_preset(std::string_view name,
                                                    array_view<const preset_description* const> presets) {
        for (const preset_description* p : presets)
            if (p->name == name)
                return p;
        refuse("there is no preset of the name", name);
        return nullptr;
    }

    constexpr void conclude() {
        if (error_.count == 0)
            error_ = check(choices()).message();
    }

    constexpr void refuse(std::string_view sentence, std::string_view word) {
        error_ << "crease::recipe: " << sentence << " '" << word.substr(0, 64) << "'";
    }

    constexpr void read_part(std::string_view word, array_view<const part* const> known) {
        const std::size_t colon = word.find(':');
        const std::string_view name = word.substr(0, colon);
        const part* found = nullptr;
        for (const part* p : known)
            if (p->name == name)
                found = p;
        if (word.empty())
            return refuse("a part's name is missing before or after a '/' in",
                          "SAMPLER/DEPTH/ESTIMATOR[/...]");
        if (!found)
            return refuse("there is no part of the name", name);
        if (choices_.full())
            return refuse("there are too many parts, beginning with", word);
        choice c{found, {}};
        for (std::size_t i = 0; i < found->numbers.size(); ++i)
            c.numbers[i] = found->numbers[i].fallback;
        if (colon != std::string_view::npos && !read_numbers(word.substr(colon + 1), c))
            return refuse(
                "the numbers after ':' are not whole numbers joined by 'x', as many as the part takes, in",
                word);
        choices_.add(c);
    }

    /// Reads `NxN...`, at least one and at most as many as the part takes.
    static constexpr bool read_numbers(std::string_view text, choice& c) {
        for (std::size_t i = 0; i < c.what->numbers.size(); ++i) {
            const std::size_t end = text.find('x');
            if (!read_number(text.substr(0, end), c.numbers[i]))
                return false;
            if (end == std::string_view::npos)
                return true;
            text.remove_prefix(end + 1);
        }
        return false;
    }

    static constexpr bool read_number(std::string_view digits, int& value) {
        if (digits.empty() || digits.size() > 9) // nine digits fit into an int
            return false;
        value = 0;
        for (char d : digits) {
            if (d < '0' || d > '9')
                return false;
            value = value * 10 + (d - '0');
        }
        return true;
    }

    choice_list choices_;
    fixed_text<512> error_;
};

}
