// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/fixed_text.hpp>

#include <string_view>

namespace crease {

// The rules of composing, each with its sentence: static assertion and run-time refusal alike.
// clang-format off
#define CREASE_RULES(rule)                                                                                             \
    rule(sampler_first, "the first part must be a sampler")                                                            \
    rule(depth_source_second, "the second part must be a depth source")                                                \
    rule(estimator_third, "the third part must be an estimator")                                                       \
    rule(rest_beside_three, "a fourth or later part must not be a sampler, a depth source or an estimator")            \
    rule(role_once, "two parts have the same role, and only filters may be more than one")                             \
    rule(in_range, "a number of a part is out of its range")                                                           \
    rule(asked_for, "a part is of use only beside a part that requires its role, and none does")                       \
    rule(full_size_input, "a filter takes a picture of full size, and the one before it makes a smaller one")          \
    rule(es_versions, "the versions of GLSL ES are 300 and 310")                                                       \
    rule(es_fragments, "GLSL ES 3.00 has fragment shaders alone, and a part needs others")                             \
    rule(es_loads, "GLSL ES 3.00 has no storage images, which a part loads")                                           \
    rule(es_layers, "GLSL ES and WebGPU have no way to capture layers, which a part needs")                            \
    rule(es_subgroups, "GLSL ES and WebGPU promise no operations of subgroups, which a part needs")                    \
    rule(strips_of_depths, "the stage keeps depths in shared memory, and a part needs layers with their opacity")      \
    rule(small_strips, "what the stage keeps takes more than the 16384 bytes of shared memory that every device has")  \
    rule(few_enough, "an effect has 16 parts at the most")                                                             \
    rule(resource_once, "two parts describe a resource of the same name")                                              \
    rule(known_resource, "a step fills a resource that no part of the effect describes")                               \
    rule(written_first, "a pass reads a resource that no pass before it fills")                                        \
    rule(few_resources, "an effect has 48 resources, 24 settings and 4 views at the most")                             \
    rule(few_passes, "an effect has 32 passes at the most, each with 8 outputs, 16 bindings and 32 constants")         \
    rule(short_programs, "a program has 500 names, 190 functions and 6000 characters of interface at the most")
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

}

}
