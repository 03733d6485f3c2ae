// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/plan.hpp>

namespace crease::rules {

template <class Part, role Role>
constexpr bool has_role = Part::description.kind == Role;

template <class Part>
constexpr bool may_follow = may_follow_three(Part::description.kind);

template <class One, class Other>
constexpr bool share_a_role = One::description.kind == Other::description.kind&& One::description.kind !=
                              role::filter&& may_follow<One>;

template <class Part>
constexpr bool in_its_range = numbers_in_range(choice_of<Part>());

template <class... Parts>
inline constexpr choice choices_of[] = {choice_of<Parts>()...};

template <class... Parts>
inline constexpr bool make_an_effect = !check(choices_of<Parts...>);

template <class Part, class... Parts>
constexpr bool is_requested =
    !is_on_request(Part::description.kind) || requires_role(choices_of<Parts...>, Part::description.kind);

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

/// The choice of a part; of anything else an empty one, after the assertion.
template <class T>
constexpr choice choice_or_none() {
    if constexpr (a_part<T>)
        return choice_of<T>();
    else
        return {};
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

template <class Trait, class Other>
constexpr bool is_met = !has_role<Other, Trait::value.from> || offers<Other, Trait>;

template <class Needer, class Trait, class Other>
constexpr bool assert_met() {
    if constexpr (is_met<Trait, Other>)
        return true;
    else
        return Trait::template met<Needer, Other>();
}

/// Of several needs that are not met the first is told.
template <class Needer, class... Others, class Trait, class... Rest>
constexpr bool assert_met_in_turn(traits<Trait, Rest...>) {
    if constexpr (!(is_met<Trait, Others> && ...))
        return (assert_met<Needer, Trait, Others>() && ...);
    else if constexpr (sizeof...(Rest) > 0)
        return assert_met_in_turn<Needer, Others...>(traits<Rest...>{});
    else
        return true;
}

template <class Needer, class... Others>
constexpr bool assert_needs() {
    if constexpr (requires { typename Needer::needs; })
        return assert_met_in_turn<Needer, Others...>(typename Needer::needs{});
    else
        return true;
}

template <class... Parts>
constexpr bool assert_every_need() {
    return (assert_needs<Parts, Parts...>() && ...);
}

/// What a stage or a dialect cannot: of all parts, those that are there by default among them.
template <class... Parts>
constexpr bool assert_whole() {
    constexpr std::string_view said = check(choices_of<Parts...>).sentence;
    return assert_strips_of_depths<said != strips_of_depths, Parts...>() &&
           assert_small_strips<said != small_strips, Parts...>() &&
           assert_es_versions<said != es_versions, Parts...>() &&
           assert_es_fragments<said != es_fragments, Parts...>() &&
           assert_es_loads<said != es_loads, Parts...>() && assert_es_layers<said != es_layers, Parts...>() &&
           assert_es_subgroups<said != es_subgroups, Parts...>();
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
                          (assert_asked_for<is_requested<Rest, Sampler, DepthSource, Estimator, Rest...>,
                                            Rest, DepthSource>() &&
                           ...) &&
                          assert_every_need<Sampler, DepthSource, Estimator, Rest...>() &&
                          assert_whole<Sampler, DepthSource, Estimator, Rest...>());
}

/// Parts that are too few fail by the place that is empty.
template <class First, class... Second>
constexpr void assert_three() {
    if constexpr (assert_sampler_first<has_role<First, role::sampler>, First>() &&
                  (assert_depth_source_second<has_role<Second, role::depth_source>, Second>() && ...)) {
        if constexpr (sizeof...(Second) == 0)
            assert_depth_source_second<false, First>();
        else
            assert_estimator_third<false, First, Second...>();
    }
}

/// Whether the parts make an effect; where they do not, an assertion says why. The rules are checked on
/// values first, as a template for each rule and part costs a compiler more than all else.
template <class... Parts>
constexpr bool assert_all() {
    if constexpr ((asserted_part<Parts>() && ...)) {
        if constexpr (make_an_effect<Parts...>)
            return true;
        else if constexpr (sizeof...(Parts) < 3)
            assert_three<Parts...>();
        else
            assert_each_rule<Parts...>();
    }
    return false;
}

}

#undef CREASE_RULES
