// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/pass.hpp>
#include <crease/effect/resource.hpp>
#include <crease/translate/target.hpp>

#include <string_view>

namespace crease::tools {

// The names of enumerators as they stand in C++, for generated headers and manifests alike.

constexpr std::string_view name_of(stage_kind stage) {
    constexpr std::string_view names[] = {"compute", "fragment", "functions", "geometry"};
    return names[static_cast<unsigned>(stage)];
}

constexpr std::string_view name_of(dialect_kind dialect) {
    constexpr std::string_view names[] = {"vulkan", "opengl", "glsl_es", "webgpu"};
    return names[static_cast<unsigned>(dialect)];
}

constexpr std::string_view name_of(dispatch covers) {
    constexpr std::string_view names[] = {"texels", "rows", "columns"};
    return names[static_cast<unsigned>(covers)];
}

constexpr std::string_view name_of(access how) {
    constexpr std::string_view names[] = {"uniform", "sample",     "load",  "store",
                                          "modify",  "attachment", "result"};
    return names[static_cast<unsigned>(how)];
}

constexpr std::string_view name_of(resource_kind kind) {
    constexpr std::string_view names[] = {"image", "buffer", "block"};
    return names[static_cast<unsigned>(kind)];
}

/// As `--target` and manifests say it.
constexpr std::string_view word_of(translate::language of) {
    constexpr std::string_view words[] = {"hlsl", "msl", "glsl-es", "glsl"};
    return words[static_cast<unsigned>(of)];
}

constexpr std::string_view name_of(lifetime life) {
    constexpr std::string_view names[] = {"input",   "constant", "transient", "handed_on",
                                          "history", "report",   "output"};
    return names[static_cast<unsigned>(life)];
}

}
