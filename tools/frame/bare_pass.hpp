// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/pass.hpp>

#include <span>

namespace crease::tools {

inline constexpr constant groups_of_16[] = {{"compute", "width", 0, 16}, {"compute", "height", 1, 16}};

/// A pass of the benchmark itself, which belongs to no effect: one invocation for each texel of the picture.
/// @param constants  the first two are the workgroup's width and height
constexpr pass bare_pass(std::span<const piece> pieces, std::span<const binding> bindings,
                         std::span<const constant> constants = groups_of_16) {
    return {.name = pieces[0].name,
            .stage = stage_kind::compute,
            .dialect = dialect_kind::vulkan,
            .pieces = pieces,
            .vertex_pieces = {},
            .bindings = bindings,
            .constants = constants,
            .size = {}};
}

}
