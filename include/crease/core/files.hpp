// SPDX-License-Identifier: MIT
#pragma once

#include <crease/glsl_file.hpp>

namespace crease {

inline constexpr glsl_file parameters_glsl{
    "core/parameters.glsl",
#include <crease/core/parameters.glsl>
};

inline constexpr glsl_file types_glsl{
    "core/types.glsl",
#include <crease/core/types.glsl>
};

inline constexpr glsl_file receiver_glsl{
    "core/receiver.glsl",
#include <crease/core/receiver.glsl>
};

inline constexpr glsl_file batch_glsl{
    "core/batch.glsl",
#include <crease/core/batch.glsl>
};

inline constexpr glsl_file gather_glsl{
    "core/gather.glsl",
#include <crease/core/gather.glsl>
};

inline constexpr glsl_file strength_glsl{
    "core/strength.glsl",
#include <crease/core/strength.glsl>
};

inline constexpr glsl_file receive_glsl{
    "core/receive.glsl",
#include <crease/core/receive.glsl>
};

inline constexpr glsl_file volume_glsl{
    "core/volume.glsl",
#include <crease/core/volume.glsl>
};

inline constexpr glsl_file visibility_glsl{
    "core/visibility.glsl",
#include <crease/core/visibility.glsl>
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

}
