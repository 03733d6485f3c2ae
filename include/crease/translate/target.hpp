// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace crease::translate {

/// The shading languages that passes are translated to.
enum class language : unsigned char {
    hlsl,    ///< Direct3D 11 and 12
    msl,     ///< Metal
    glsl_es, ///< OpenGL ES, WebGL 2
    glsl     ///< OpenGL
};

/// As in "GLSL ES".
constexpr std::string_view name_of(language of) {
    constexpr std::string_view names[] = {"HLSL", "MSL", "GLSL ES", "GLSL"};
    return names[static_cast<unsigned>(of)];
}

}

namespace crease::translate::detail {

inline constexpr unsigned hlsl_versions[] = {50, 51, 60}, msl_versions[] = {21, 22, 23, 24, 30},
                          glsl_es_versions[] = {300, 310, 320}, glsl_versions[] = {430, 440, 450, 460};
inline constexpr std::span<const unsigned> versions[] = {hlsl_versions, msl_versions, glsl_es_versions,
                                                         glsl_versions};

}

namespace crease::translate {

/// The versions of a language that passes are translated to: of HLSL shader models, 50 being 5.0; of MSL 21
/// for 2.1; of GLSL as after `#version`.
constexpr std::span<const unsigned> versions_of(language of) {
    return detail::versions[static_cast<unsigned>(of)];
}

/// Where a host wants a binding; what is not said is counted on.
struct place {
    std::optional<unsigned> number{};  ///< register, index or unit
    std::optional<unsigned> sampler{}; ///< of a sampled image in HLSL and MSL
    unsigned space = 0;                ///< in HLSL from 5.1 on: register space
};

/// What a pass is translated to.
struct target {
    language to = language::hlsl; ///< which language
    unsigned version = 50;        ///< one of `versions_of`
    std::string entry_point{}; ///< in HLSL and MSL; empty: `main`, which MSL forbids, and there `<pass>_main`
    std::map<std::string, place> places{};  ///< by name of the binding, as in "depth"; "buffer_sizes" in MSL
    std::map<std::string, int> constants{}; ///< other defaults of specialization constants, by "part.number"
    bool frozen = false;                    ///< constants are literals, which nothing sets later
};

/// As in "HLSL 5.1", "MSL 2.3", "GLSL ES 3.10".
inline std::string name_of(const target& of) {
    const bool in_tens = of.to == language::hlsl || of.to == language::msl;
    const unsigned whole = of.version / (in_tens ? 10 : 100), rest = of.version % (in_tens ? 10 : 100);
    return std::string(name_of(of.to)) + " " + std::to_string(whole) + "." +
           (in_tens || rest > 9 ? "" : "0") + std::to_string(rest);
}

}
