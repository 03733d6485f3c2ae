// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// The version of crease, which follows Semantic Versioning.

#include <string_view>

/// The version in three numbers.
/// @{
#define CREASE_VERSION_MAJOR 0
#define CREASE_VERSION_MINOR 2
#define CREASE_VERSION_PATCH 0
/// @}

/// The version as one number that grows with it, as in `#if CREASE_VERSION >= 200`: 0.2.0 is 200, 1.2.3 is
/// 10203.
#define CREASE_VERSION (CREASE_VERSION_MAJOR * 10000 + CREASE_VERSION_MINOR * 100 + CREASE_VERSION_PATCH)

namespace crease {

/// The version as text, "0.2.0"; the first line of each emitted shader names it.
inline constexpr std::string_view version = "0.2.0";

}
