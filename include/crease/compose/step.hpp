// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/glsl_file.hpp>
#include <crease/compose/trait.hpp>
#include <crease/effect/access.hpp>
#include <crease/effect/array_view.hpp>

#include <string_view>

namespace crease {

/// What runs a step, and what its GLSL defines.
enum class step_kind : unsigned char {
    result, ///< `crease_result crease_evaluate(ivec2 pixel)`: the main pass, and after it those of filters,
            ///< each of which reads what the one before hands on; in the stage of the effect
    texels, ///< compute, `void crease_build(ivec2 texel)` for each texel of what it writes
    rows, ///< compute, `void crease_build_line(int line)`, which the invocations of a workgroup in a row call
          ///< together for a row. The workgroup's height is that many rows, and the last lines may lie
          ///< outside
    columns, ///< the same for a column, of the invocations in a column of the workgroup
    geometry ///< `void crease_capture(vec3 anchor)`, for fragments of the host's geometry
};

/// GLSL that stands before other files where a part of the effect needs a trait: what offers the trait does
/// more there, and elsewhere its programs stay as they are.
struct files_where {
    const trait* needed = nullptr;              ///< null: nowhere
    array_view<const glsl_file* const> files{}; ///< searched first
};

/// A `const int` of one step; in GLSL crease_<part>_<name>.
struct step_constant {
    std::string_view name; ///< without the part's
    int value;             ///< in every program of the step
    std::string_view of{}; ///< takes the place of the part's name, where parts share the GLSL
};

/// A pass as a part describes it. Steps of all kinds but `result` run before the main pass, or after the last
/// filter; those of one part in their order, the parts in the order of their roles.
struct step {
    std::string_view name;                       ///< of the pass
    array_view<const glsl_file* const> files{};  ///< its own GLSL, which stands before that of the parts
    files_where widened{};                       ///< before these, where more is needed of the step
    step_kind kind = step_kind::result;          ///< what its GLSL defines, and what runs it
    bool after = false;                          ///< whether it runs after the last filter
    array_view<const step_constant> constants{}; ///< of its program alone
    array_view<const std::string_view>
        writes{};                  ///< resources of the effect's parts that it fills, of one size; those that
                                   ///< its program does not name it has nothing to do with
    access how = access::store;    ///< how it fills them
    int group_width = 16;          ///< width of the workgroup, invocations, where `kind` is not `result`
    int group_height = 16;         ///< height, likewise
    int from = 0;                  ///< the part's first number from which on the step is there
    const trait* needed = nullptr; ///< that a part of the effect must need, or the step is not there; null:
                                   ///< always
    int times = 1;                 ///< how often it runs, one after the other
    unsigned level = 0;            ///< mip level that it writes
    bool further_levels = false; ///< whether it runs once for each level from that on, where it reads the one
                                 ///< before by `crease_load_input`
    bool per_view = false;       ///< whether it runs once for each camera
    bool full_size_input = false; ///< of a filter, whether its input must be as large as the picture
    int upsampling = -1; ///< of a filter, index of the number by which its output is larger; -1: none
};

}
