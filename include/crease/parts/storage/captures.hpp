// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/part.hpp>

namespace crease {

/// The numbers of every layer storage: where its bindings and constants are among those of the host's
/// geometry pass.
inline constexpr number capture_places[] = {
    {"set", 0, 31, 0, "descriptor set of its bindings in the host's geometry pass"},
    {"first_binding", 0, 1023, 0, "binding of the block of parameters; the others follow"},
    {"first_constant", 0, 1023, 0, "constant_id of the first number; the others follow"},
};

/// Names of the captured layers of the cameras beside the picture's.
inline constexpr std::string_view further_captured_layers[] = {"captured_layers_1", "captured_layers_2",
                                                               "captured_layers_3"};
/// The name of those of the picture's camera.
inline constexpr std::string_view captured_layers_name[] = {"captured_layers"};

/// The geometry pass that captures the layers, once for each camera.
constexpr step capture_layers(array_view<const glsl_file* const> drawing, access how) {
    return {.name = "capture_layers",
            .files = drawing,
            .kind = step_kind::geometry,
            .writes = captured_layers_name,
            .how = how,
            .per_view = true};
}

/// As many samples as the depth source keeps of a texel: a power of 2, at least 2.
constexpr void shape_samples(resource& own, const shape_of& effect) {
    own.samples = 2;
    while (own.samples < static_cast<unsigned>(effect.number_of(role::depth_source, "count")))
        own.samples *= 2;
}

/// As many layers as the depth source keeps of a texel.
constexpr void shape_layers(resource& own, const shape_of& effect) {
    own.layers = static_cast<unsigned>(effect.number_of(role::depth_source, "count"));
}

}
