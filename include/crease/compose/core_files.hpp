// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/glsl_file.hpp>

namespace crease {

inline constexpr glsl_file view_glsl{
    "core/view.glsl",
#include <crease/core/view.glsl>
};

inline constexpr glsl_file texels_glsl{
    "core/texels.glsl",
#include <crease/core/texels.glsl>
};

inline constexpr glsl_file receiver_glsl{
    "core/receiver.glsl",
#include <crease/core/receiver.glsl>
};

inline constexpr glsl_file eye_side_glsl{
    "core/eye_side.glsl",
#include <crease/core/eye_side.glsl>
};

inline constexpr glsl_file layer_glsl{
    "core/layer.glsl",
#include <crease/core/layer.glsl>
};

inline constexpr glsl_file fetch_glsl{
    "core/fetch.glsl",
#include <crease/core/fetch.glsl>
};

inline constexpr glsl_file combine_glsl{
    "core/combine.glsl",
#include <crease/core/combine.glsl>
};

inline constexpr glsl_file fade_glsl{
    "core/fade.glsl",
#include <crease/core/fade.glsl>
};

inline constexpr glsl_file blend_glsl{
    "core/blend.glsl",
#include <crease/core/blend.glsl>
};

inline constexpr glsl_file skip_behind_glsl{
    "core/skip_behind.glsl",
#include <crease/core/skip_behind.glsl>
};

inline constexpr glsl_file slice_weight_glsl{
    "core/slice_weight.glsl",
#include <crease/core/slice_weight.glsl>
};

inline constexpr glsl_file gathered_glsl{
    "core/gathered.glsl",
#include <crease/core/gathered.glsl>
};

inline constexpr glsl_file gather_glsl{
    "core/gather.glsl",
#include <crease/core/gather.glsl>
};

inline constexpr glsl_file result_glsl{
    "core/result.glsl",
#include <crease/core/result.glsl>
};

inline constexpr glsl_file bits_glsl{
    "core/bits.glsl",
#include <crease/core/bits.glsl>
};

inline constexpr glsl_file no_normal_glsl{
    "core/no_normal.glsl",
#include <crease/core/no_normal.glsl>
};

inline constexpr glsl_file strength_glsl{
    "core/strength.glsl",
#include <crease/core/strength.glsl>
};

inline constexpr glsl_file pixel_glsl{
    "core/pixel.glsl",
#include <crease/core/pixel.glsl>
};

inline constexpr glsl_file build_glsl{
    "stage/build.glsl",
#include <crease/stage/build.glsl>
};

inline constexpr glsl_file build_rows_glsl{
    "stage/build_rows.glsl",
#include <crease/stage/build_rows.glsl>
};

inline constexpr glsl_file build_columns_glsl{
    "stage/build_columns.glsl",
#include <crease/stage/build_columns.glsl>
};

/// What every program may call: each is a default, in whose place a part may define its own.
inline constexpr const glsl_file* core_files[] = {
    &view_glsl,    &texels_glsl, &receiver_glsl,  &eye_side_glsl,    &layer_glsl,        &fetch_glsl,
    &combine_glsl, &fade_glsl,   &blend_glsl,     &skip_behind_glsl, &slice_weight_glsl, &gathered_glsl,
    &gather_glsl,  &result_glsl, &no_normal_glsl, &strength_glsl,    &pixel_glsl,        &bits_glsl};

}
