// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/parse.hpp>
#include <crease/translate/target.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace crease::translate {

/// What is counted apart in a language: HLSL's registers, MSL's argument tables, the binding points of
/// OpenGL.
enum class number_kind : unsigned char {
    b_register,    ///< HLSL: constant buffers
    t_register,    ///< HLSL: what is only read
    u_register,    ///< HLSL: what is written
    buffer_index,  ///< MSL: blocks and buffers
    texture_index, ///< MSL: images
    uniform_block, ///< GLSL: `glBindBufferBase(GL_UNIFORM_BUFFER)`
    texture_unit,  ///< GLSL: `glActiveTexture`
    image_unit,    ///< GLSL: `glBindImageTexture`
    shader_storage ///< GLSL: `glBindBufferBase(GL_SHADER_STORAGE_BUFFER)`
};

/// As in "u_register".
constexpr std::string_view name_of(number_kind of) {
    constexpr std::string_view names[] = {"b_register",   "t_register",    "u_register",
                                          "buffer_index", "texture_index", "uniform_block",
                                          "texture_unit", "image_unit",    "shader_storage"};
    return names[static_cast<unsigned>(of)];
}

/// A binding of a pass, in the numbers of its language.
struct placed_binding {
    std::string name;       ///< of the binding, as in "depth"
    std::string identifier; ///< in the text, as in "crease_depth"; of a block in HLSL and GLSL that of the
                            ///< block; empty where the text has it not
    number_kind kind = number_kind::b_register; ///< what `number` counts
    unsigned number = 0;                        ///< register, index or unit
    unsigned space = 0;                         ///< in HLSL: register space
    std::optional<unsigned> sampler;            ///< of a sampled image: s register, index of a sampler
};

/// A specialization constant, as a host sets it in the language.
struct placed_constant {
    std::string part;   ///< e.g. "directions"; empty for one of a host's own
    std::string number; ///< e.g. "steps"
    unsigned id = 0;    ///< constant_id; in MSL index of the function constant
    std::string macro;  ///< in HLSL and GLSL: what the host may define, as in CREASE_DIRECTIONS_STEPS
    int value = 0;      ///< where the host sets nothing
};

/// A shader in another language, and all that its host must be told beyond what the pass says.
struct translation {
    target made_for;                                          ///< as it was asked for
    spirv::shader_stage stage = spirv::shader_stage::compute; ///< what it runs as
    std::string text;                                         ///< the whole shader
    std::string entry_point;                                  ///< its name
    unsigned group_width = 0;               ///< of a compute shader: invocations of a workgroup
    unsigned group_height = 0;              ///< the same, other axis; 1 deep
    std::vector<placed_binding> bindings;   ///< those of the pass in its order, then a host's own
    std::vector<placed_constant> constants; ///< those that can still be set: none where they are frozen

    /// In MSL, where the shader asks for the length of a buffer: the buffer_index of an array of `uint` that
    /// the host fills, at the buffer_index of each storage buffer with its size in bytes.
    std::optional<unsigned> buffer_sizes;
};

}
