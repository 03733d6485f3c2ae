// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/effect_view.hpp>
#include <crease/spirv/optimise.hpp>
#include <crease/translate/translation.hpp>

#include <optional>
#include <string>
#include <vector>

namespace crease::tools {

/// What is made of SPIR-V beyond compiling it.
struct spirv_options {
    std::optional<spirv::vulkan_version> target; ///< unset: 1.1
    std::optional<spirv::goal> optimise;         ///< unset: as glslang gives it
    bool strip = false;                          ///< without the names that debuggers show

    bool any() const { return target || optimise || strip; }
    spirv::vulkan_version version() const { return target.value_or(spirv::vulkan_version::v1_1); }
};

/// A shader of a pass among the files: what the manifest says of it.
struct emitted_shader {
    std::string_view stage; ///< "compute", "fragment", "vertex", or "functions" and "geometry" without `main`
    std::string_view format; ///< "glsl", "spirv", "spirv-asm", "wgsl", "hlsl", "msl" or "glsl-es"
    std::string file;
    std::string symbol{};                                ///< in a C++ header; empty elsewhere
    std::optional<translate::translation> translation{}; ///< where it is one
};

/// A pass on its way into files.
struct emitted_pass {
    std::string name;          ///< of the pass, as an identifier that no other pass has
    spirv::words main, vertex; ///< empty where it is emitted as GLSL
    std::vector<emitted_shader> shaders;
};

/// An effect on its way into files.
struct emission {
    effect_view effect;
    std::string name; ///< of the header, its namespace and the manifest
    spirv_options spirv;
    std::vector<emitted_pass> passes; ///< in the order of the effect
};

/// Whether a pass is a program that SPIR-V is made of.
constexpr bool has_spirv(const pass& p) {
    return (p.stage == stage_kind::compute || p.stage == stage_kind::fragment) &&
           (p.dialect == dialect_kind::vulkan || p.dialect == dialect_kind::webgpu);
}

/// The passes of an effect, with SPIR-V of those that have it where it is wanted. It is validated.
/// @throws spirv::error  where a pass does not compile for the version of Vulkan
std::vector<emitted_pass> prepare(const effect_view& effect, bool with_spirv, const spirv_options& options);

/// The GLSL of a pass or a vertex shader as one text.
std::string joined(array_view<const piece> pieces);

/// The texels of a constant resource.
std::vector<std::uint32_t> texels_of(const resource& constant);

}
