// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect.hpp>
#include <crease/parts.hpp>

#include <string_view>

namespace crease {

/// The parts of an effect chosen at run time, from text or from values, or the reason why they make none.
///
/// The text is `SAMPLER/DEPTH/ESTIMATOR` and then `/PART` for each filter, in the order in which they run,
/// and for each view part, stage or dialect that is not the default. A part is its name and, where it takes
/// numbers,
/// `:NxN...`; without them it has its defaults: `directions:8x4/single_layer/hbao/bilateral`.
class recipe {
public:
    /// The same choices as values, in the same order.
    constexpr recipe(array_view<const choice> choices) {
        for (const choice& c : choices)
            if (!choices_.full())
                choices_.add(c);
        conclude();
    }

    /// From text. `known` are the parts that it may name: a host adds its own to `all_parts`.
    constexpr recipe(std::string_view text, array_view<const part* const> known = all_parts) {
        while (error_.count == 0) {
            const std::size_t slash = text.find('/');
            read_part(text.substr(0, slash), known);
            if (slash == std::string_view::npos)
                break;
            text.remove_prefix(slash + 1);
        }
        conclude();
    }

    /// Whether the parts make an effect.
    constexpr explicit operator bool() const { return error_.count == 0; }

    /// One sentence that says why not; empty where they do. The same as the static assertion of `effect`.
    constexpr std::string_view error() const { return error_.view(); }

    constexpr array_view<const choice> choices() const { return choices_; }

    /// The recipe as text, with all numbers.
    constexpr fixed_text<512> text() const {
        fixed_text<512> out;
        for (const choice& c : choices()) {
            out << (out.count ? "/" : "") << c.what->name;
            for (std::size_t i = 0; i < c.what->numbers.size(); ++i)
                out << (i == 0 ? ":" : "x") << c.numbers[i];
        }
        return out;
    }

private:
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

/// The effect of a recipe: the passes as data, in storage of its own.
///
/// The text of its passes is byte for byte that of the `effect` with the same parts. The object is large
/// (about 300 KB) and stays where it is made, as its passes view it.
class composition {
public:
    /// `from` must make an effect; otherwise there are no passes.
    explicit composition(const recipe& from) {
        if (!from)
            return;
        const plan planned = make_plan(from.choices());
        for (const planned_capture& each : planned.captures)
            captures_.add(described<capture>(planned, each));
        for (const planned_pass& each : planned.passes)
            passes_.add(described<pass>(planned, each));
        resources_ = planned.resources;
        features_ = required_features(planned);
        defaults_ = default_parameters(planned.choices);
    }
    composition(const composition&) = delete;
    composition& operator=(const composition&) = delete;

    effect_view view() const { return {captures_, passes_, resources_, features_, defaults_}; }
    operator effect_view() const { return view(); }

private:
    struct storage {
        program written;
        char interface[interface_text::most_characters];
        glsl_file pieces[1 + 40];
        std::size_t piece_count = 0;
    };

    /// A pass or a capture with its lists.
    template <class Described, class Planned>
    Described described(const plan& planned, const Planned& each) {
        storage& own = storage_[used_++];
        own.written = write_program(planned, each);
        own.written.interface.write(own.interface);
        own.pieces[own.piece_count++] = {"interface",
                                         std::string_view(own.interface, own.written.interface.size())};
        for (const glsl_file* file : own.written.files)
            own.pieces[own.piece_count++] = *file;
        Described whole = describe(planned, each);
        whole.pieces = {own.pieces, own.piece_count};
        whole.bindings = own.written.bindings;
        whole.constants = own.written.constants;
        return whole;
    }

    storage storage_[most_captures + most_passes];
    std::size_t used_ = 0;
    fixed_list<capture, most_captures> captures_;
    fixed_list<pass, most_passes> passes_;
    fixed_list<resource, most_resources> resources_;
    device_features features_;
    parameters defaults_;
};

}
