// SPDX-License-Identifier: MIT
#pragma once

#include <crease/array_view.hpp>
#include <crease/defaults.hpp>
#include <crease/fixed_list.hpp>
#include <crease/outlined_parts.hpp>
#include <crease/part.hpp>

#include <cstddef>
#include <string_view>

namespace crease {

/// The most parts that an effect may consist of, those filled in by default included.
inline constexpr std::size_t most_parts = 24;

/// The most of these that may be named: the others are left to defaults.
inline constexpr std::size_t most_chosen = 16;

/// The parts of an effect in order: sampler, depth source, estimator, and then the rest.
using choice_list = fixed_list<choice, most_parts>;

// The rules of composing, each with its sentence: static assertion and run-time refusal alike.
// clang-format off
#define CREASE_RULES(rule)                                                                                             \
    rule(sampler_first, "the first part must be a sampler")                                                            \
    rule(depth_source_second, "the second part must be a depth source")                                                \
    rule(estimator_third, "the third part must be an estimator")                                                       \
    rule(rest_beside_three, "a fourth or later part must not be a sampler, a depth source or an estimator")            \
    rule(role_once, "two parts have the same role, and only filters may be more than one")                             \
    rule(in_range, "a number of a part is out of its range")                                                           \
    rule(asked_for, "a part is of use only beside a depth source that asks for one of its role, and this one asks for none")    \
    rule(full_size_input, "a filter takes a picture of full size, and the one before it makes a smaller one")          \
    rule(few_enough, "an effect has 16 parts at the most")
// clang-format on

/// Why an effect is refused; `sentence` is empty where it is not.
struct refusal {
    std::string_view sentence{};
    std::string_view first{}, second{}; ///< the parts that it is about

    constexpr explicit operator bool() const { return !sentence.empty(); }

    /// One sentence that names the parts and the reason.
    constexpr fixed_text<512> message() const {
        fixed_text<512> text;
        if (*this)
            text << "crease::effect: " << sentence << " (" << first << (second.empty() ? "" : ", ") << second
                 << ")";
        return text;
    }
};

namespace rules {

#define CREASE_RULE(name_, sentence_) inline constexpr std::string_view name_ = sentence_;
CREASE_RULES(CREASE_RULE)
#undef CREASE_RULE

constexpr bool numbers_in_range(const choice& c) {
    for (std::size_t i = 0; i < c.what->numbers.size(); ++i)
        if (!open_number::is(c.numbers[i]) &&
            (c.numbers[i] < c.what->numbers[i].least || c.numbers[i] > c.what->numbers[i].most))
            return false;
    return true;
}

/// Whether a role is empty unless another part wants it.
constexpr bool waits_to_be_wanted(role r) {
    return r == role::layer_carrier || r == role::layer_sampling || r == role::fold || r == role::scan;
}

constexpr bool wants(const part& p, role wanted) {
    for (role r : p.wants)
        if (r == wanted)
            return true;
    return false;
}

constexpr bool may_follow_three(role r) {
    return r != role::sampler && r != role::depth_source && r != role::estimator;
}

/// The part's factor between the resolutions of its input and its output; 1 where it has none.
constexpr unsigned upsampling_of(const choice& c) {
    return c.what->upsampling < 0 ? 1u : static_cast<unsigned>(c.numbers[c.what->upsampling]);
}

constexpr bool takes_full_size(const choice& c) {
    for (const step& s : c.what->steps)
        if (s.full_size_input)
            return true;
    return false;
}

/// Whether no later filter, nor this one, makes the picture larger than the input of `choices[at]`.
constexpr bool input_is_full_size(array_view<const choice> choices, std::size_t at) {
    for (std::size_t i = at; i < choices.size(); ++i)
        if (upsampling_of(choices[i]) != 1)
            return false;
    return true;
}

}

/// Checks parts chosen at run time by the same rules as `effect` does at compile time.
constexpr refusal check(array_view<const choice> choices) {
    if (choices.size() > most_chosen)
        return {rules::few_enough, choices[most_chosen].what->name};
    constexpr role first_three[] = {role::sampler, role::depth_source, role::estimator};
    constexpr std::string_view sentences[] = {rules::sampler_first, rules::depth_source_second,
                                              rules::estimator_third};
    for (std::size_t i = 0; i < 3; ++i)
        if (i >= choices.size() || choices[i].what->kind != first_three[i])
            return {sentences[i], i < choices.size() ? choices[i].what->name : "there is none"};
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const part& p = *choices[i].what;
        if (i >= 3 && !rules::may_follow_three(p.kind))
            return {rules::rest_beside_three, p.name};
        for (std::size_t j = 3; j < i; ++j)
            if (p.kind != role::filter && choices[j].what->kind == p.kind)
                return {rules::role_once, choices[j].what->name, p.name};
        if (!rules::numbers_in_range(choices[i]))
            return {rules::in_range, p.name};
        if (rules::waits_to_be_wanted(p.kind) && !rules::wants(*choices[1].what, p.kind))
            return {rules::asked_for, p.name, choices[1].what->name};
        for (const trait* needed : p.needs)
            for (const choice& other : choices)
                if (other.what->kind == needed->from && !has(other.what->offers, needed))
                    return {needed->sentence, p.name, other.what->name};
        if (rules::takes_full_size(choices[i]) && !rules::input_is_full_size(choices, i))
            return {rules::full_size_input, p.name};
    }
    return {};
}

/// Adds the default part of each role that only has to be named where it differs.
constexpr choice_list complete(array_view<const choice> choices) {
    choice_list all;
    for (const choice& c : choices)
        all.add(c);
    for (const choice& fallback : default_choices) {
        const role wanted = fallback.what->kind;
        bool there = rules::waits_to_be_wanted(wanted) && !rules::wants(*choices[1].what, wanted);
        for (const choice& c : choices)
            there = there || c.what->kind == wanted;
        if (!there)
            all.add(fallback);
    }
    return all;
}

namespace rules {

template <class Part, role Role>
constexpr bool has_role = Part::description.kind == Role;

template <class Part>
constexpr bool may_follow = may_follow_three(Part::description.kind);

template <class One, class Other>
constexpr bool share_a_role = One::description.kind == Other::description.kind&& One::description.kind !=
                              role::filter&& may_follow<One>;

template <class Part>
constexpr bool in_its_range = numbers_in_range(choice_of<Part>());

template <class Outline>
inline constexpr bool make_an_effect = !check(Outline::parts);

template <class Part, class DepthSource>
constexpr bool is_wanted =
    !waits_to_be_wanted(Part::description.kind) || wants(DepthSource::description, Part::description.kind);

template <class Filter, class... After>
constexpr bool gets_full_size = [] {
    const choice later[] = {choice_of<Filter>(), choice_of<After>()...};
    return !takes_full_size(later[0]) || input_is_full_size(later, 0);
}();

template <class T>
constexpr bool asserted_part() {
    static_assert(a_part<T>,
                  "crease::effect: a template argument is not a part: it has no `description` of type "
                  "crease::part");
    return a_part<T>;
}

// Each assertion stands alone in a template over the parts that it is about, so that the compiler names them.
#define CREASE_RULE(name_, sentence_)                                                                        \
    template <bool Holds, class... Parts>                                                                    \
    constexpr bool assert_##name_() {                                                                        \
        static_assert(Holds, "crease::effect: " sentence_);                                                  \
        return Holds;                                                                                        \
    }
CREASE_RULES(CREASE_RULE)
#undef CREASE_RULE

template <class Part, class... After>
constexpr bool assert_alone() {
    return assert_in_range<in_its_range<Part>, Part>() &&
           (assert_role_once<!share_a_role<Part, After>, Part, After>() && ...) &&
           assert_full_size_input<gets_full_size<Part, After...>, Part, After...>();
}

template <class First, class... Rest>
constexpr bool assert_each() {
    return assert_alone<First, Rest...>() && [] {
        if constexpr (sizeof...(Rest) > 0)
            return assert_each<Rest...>();
        return true;
    }();
}

template <class Needer, class Trait, class Other>
constexpr bool assert_met() {
    if constexpr (has_role<Other, Trait::value.from>)
        return Trait::template met<Needer, Other>();
    else
        return true;
}

template <class Needer, class... Others>
constexpr bool assert_needs() {
    if constexpr (requires { typename Needer::needs; })
        return []<class... Traits>(traits<Traits...>) {
            constexpr auto one = []<class Trait>(Trait*) {
                return (assert_met<Needer, Trait, Others>() && ...);
            };
            return (one(static_cast<Traits*>(nullptr)) && ...);
        }(typename Needer::needs{});
    else
        return true;
}

template <class... Parts>
constexpr bool assert_every_need() {
    return (assert_needs<Parts, Parts...>() && ...);
}

/// Asserts every rule on the parts of an effect, each with the types that it is about.
template <class Sampler, class DepthSource, class Estimator, class... Rest>
constexpr void assert_each_rule() {
    if constexpr (assert_sampler_first<has_role<Sampler, role::sampler>, Sampler>() &&
                  assert_depth_source_second<has_role<DepthSource, role::depth_source>, DepthSource>() &&
                  assert_estimator_third<has_role<Estimator, role::estimator>, Estimator>() &&
                  (assert_rest_beside_three<may_follow<Rest>, Rest>() && ...) &&
                  assert_few_enough<(3 + sizeof...(Rest) <= most_chosen), Rest...>())
        static_cast<void>(assert_each<Sampler, DepthSource, Estimator, Rest...>() &&
                          (assert_asked_for<is_wanted<Rest, DepthSource>, Rest, DepthSource>() && ...) &&
                          assert_every_need<Sampler, DepthSource, Estimator, Rest...>());
}

template <class... Parts>
constexpr auto assert_all() {
    if constexpr ((asserted_part<Parts>() && ...)) {
        if constexpr (make_an_effect<outlined_parts<Parts...>> && (in_its_range<Parts> && ...))
            return outlined_parts<Parts...>{};
        else
            assert_each_rule<Parts...>();
    }
}

/// The outline of parts that make an effect; where they do not, an assertion says why, and it is void. The
/// rules are checked on values first, as a template for each rule and part costs a compiler more than all
/// else.
template <class... Parts>
using legal_outline = decltype(assert_all<Parts...>());

}

#undef CREASE_RULES

}
