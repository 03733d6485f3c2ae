// SPDX-License-Identifier: MIT
#pragma once

#include <crease/translate/numbering.hpp>
#include <crease/translate/usage.hpp>

#include <spirv/unified1/GLSL.std.450.h>

namespace crease::translate::detail {

constexpr bool is_glsl(const target& to) {
    return to.to == language::glsl || to.to == language::glsl_es;
}

/// Why a shader has no counterpart in a language, beginning after "it"; empty where it may have one.
class limits {
public:
    limits(const spirv::reflection& module, const usage& uses, const target& to)
        : module_(module), uses_(uses), to_(to) {}

    std::string reason() const {
        std::string found = of_bindings();
        if (found.empty())
            found = of_subgroups();
        if (found.empty() && to_.to == language::hlsl && uses_.builtins.contains(spv::BuiltInNumWorkgroups))
            found = "asks for the number of workgroups, which HLSL does not tell";
        if (found.empty() && to_.to == language::msl)
            found = of_msl();
        if (found.empty() && to_.to == language::glsl_es)
            found = of_es();
        return found;
    }

private:
    const spirv::reflection& module_;
    const usage& uses_;
    const target& to_;

    /// What crease has none of, and a host's own shader may have.
    std::string of_bindings() const {
        for (const spirv::bound_resource& each : module_.bindings)
            if (each.kind == binding_kind::other)
                return "binds " + each.name +
                       ", and what is translated binds blocks, storage images and images with their samplers";
        return "";
    }

    std::string of_subgroups() const {
        if (std::ranges::none_of(uses_.capabilities, is_of_subgroups))
            return "";
        if (is_glsl(to_))
            return "uses operations of subgroups, which GLSL has for Vulkan alone";
        if (to_.to != language::hlsl)
            return "";
        if (to_.version < 60)
            return "uses operations of subgroups, which HLSL has from 6.0 on";
        return uses_.builtins.contains(spv::BuiltInSubgroupId)
                   ? "asks for the index of its subgroup, which HLSL does not tell"
                   : "";
    }
    static bool is_of_subgroups(unsigned capability) {
        return capability >= spv::CapabilityGroupNonUniform &&
               capability <= spv::CapabilityGroupNonUniformQuad;
    }

    /// What SPIRV-Cross writes for atomic operations on images takes no heed of the layer.
    std::string of_msl() const {
        return uses_.operations.contains(spv::OpImageTexelPointer)
                   ? "changes an image by atomic operations, which MSL has from 3.1 on"
                   : "";
    }

    std::string of_es() const {
        if (uses_.operations.contains(spv::OpImageQueryLevels))
            return "asks for the number of mip levels, which GLSL ES does not tell";
        if (to_.version < 310)
            if (const std::string found = of_es_300(); !found.empty())
                return found;
        for (const spirv::bound_resource& image : module_.bindings)
            if (image.kind == binding_kind::storage_image && image.texels != format::none)
                if (const std::string found = of_es_image(image); !found.empty())
                    return found;
        return "";
    }

    std::string of_es_300() const {
        constexpr const char* from_310 = ", which GLSL ES has from 3.10 on";
        if (module_.model == spirv::execution_model::compute)
            return std::string("is a compute shader") + from_310;
        for (const spirv::bound_resource& each : module_.bindings)
            if (each.kind == binding_kind::storage_image || each.kind == binding_kind::storage_block)
                return "has " + each.name + " as " + std::string(spirv::detail::name_of(each.kind)) +
                       from_310;
            else if (each.multisampled)
                return "has " + each.name + " as a multisampled image" + from_310;
        const bool has_bits = uses_.is_any_of({spv::OpBitCount, spv::OpBitReverse, spv::OpBitFieldInsert,
                                               spv::OpBitFieldSExtract, spv::OpBitFieldUExtract});
        const bool has_places_of_bits =
            uses_.calls_any_of({GLSLstd450FindILsb, GLSLstd450FindSMsb, GLSLstd450FindUMsb});
        if (has_bits || has_places_of_bits)
            return std::string("counts, finds or moves bits") + from_310;
        if (uses_.calls_any_of({GLSLstd450PackSnorm4x8, GLSLstd450PackUnorm4x8, GLSLstd450UnpackSnorm4x8,
                                GLSLstd450UnpackUnorm4x8}))
            return std::string("packs or unpacks four bytes") + from_310;
        if (uses_.builtins.contains(spv::BuiltInSampleMask))
            return "sets the sample mask, which GLSL ES has from 3.20 on, and 3.10 by an extension";
        return "";
    }

    static std::string of_es_image(const spirv::bound_resource& image) {
        constexpr format any[] = {format::rgba8_unorm,  format::r32_uint,     format::rgba32_uint,
                                  format::rgba16_float, format::rgba32_float, format::r32_float},
                         both_ways[] = {format::r32_uint, format::r32_float};
        const std::string what =
            image.name + " as a storage image of " + std::string(facts_of(image.texels).name);
        if (std::ranges::find(any, image.texels) == std::end(any))
            return "has " + what +
                   ", and GLSL ES has rgba8_unorm, r32_uint, rgba32_uint, "
                   "r32_float, rgba16_float and rgba32_float";
        if (image.readable && image.writable &&
            std::ranges::find(both_ways, image.texels) == std::end(both_ways))
            return "reads and writes " + what + ", which GLSL ES does with r32_float and r32_uint alone";
        return "";
    }
};

/// @throws error  where a language or its version cannot what a pass does
inline void expect_possible(const pass& which, const spirv::reflection& module, const usage& uses,
                            const target& to) {
    if (const std::string reason = limits(module, uses, to).reason(); !reason.empty())
        throw error(title_of(which, to) + ": it " + reason);
}

/// @throws error  where a version is none of those that passes are translated to
inline void expect_version(const pass& which, const target& to) {
    const std::span<const unsigned> known = versions_of(to.to);
    if (std::ranges::find(known, to.version) != known.end())
        return;
    std::string list;
    for (const unsigned each : known)
        list += (list.empty() ? "" : ", ") + std::to_string(each);
    throw error(title_of(which, to) + ": the versions of " + std::string(name_of(to.to)) + " are " + list);
}

/// @throws error  where a pass has no `main`
inline void expect_whole(const pass& which, const target& to) {
    if (which.stage == stage_kind::geometry || which.stage == stage_kind::functions)
        throw error(title_of(which, to) + " by itself: it is functions for " +
                    (which.stage == stage_kind::geometry ? "the host's geometry" : "an engine's own shader") +
                    "; compile them within that to SPIR-V, and translate the module");
}

}
