// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/version.hpp>
#include <crease/spirv/compile.hpp>
#include <crease/spirv/reflect.hpp>
#include <crease/translate/constants.hpp>
#include <crease/translate/limits.hpp>

#include <spirv_glsl.hpp>
#include <spirv_hlsl.hpp>
#include <spirv_msl.hpp>

#include <memory>

namespace crease::translate::detail {

/// A module with all that its translation says of it but the text.
struct shader_source {
    spirv::words module;
    std::vector<wanted_binding> wanted;
    translation made;

    spv::ExecutionModel model() const {
        constexpr spv::ExecutionModel models[] = {spv::ExecutionModelVertex, spv::ExecutionModelFragment,
                                                  spv::ExecutionModelGLCompute};
        return models[static_cast<unsigned>(made.stage)];
    }
};

inline std::unique_ptr<spirv_cross::CompilerGLSL> hlsl_compiler(const shader_source& of) {
    auto compiler = std::make_unique<spirv_cross::CompilerHLSL>(of.module);
    spirv_cross::CompilerHLSL::Options options;
    options.shader_model = of.made.made_for.version;
    options.use_entry_point_name = true;
    options.nonwritable_uav_texture_as_srv = true; // of u registers many formats cannot be read
    compiler->set_hlsl_options(options);
    for (std::size_t i = 0; i < of.wanted.size(); ++i) {
        const placed_binding& p = of.made.bindings[i];
        const spirv_cross::HLSLResourceBinding::Binding place{p.space, p.number};
        compiler->add_hlsl_resource_binding({of.model(),
                                             of.wanted[i].set,
                                             of.wanted[i].slot,
                                             place,
                                             place,
                                             place,
                                             {p.space, p.sampler.value_or(0)}});
    }
    return compiler;
}

inline std::unique_ptr<spirv_cross::CompilerGLSL> msl_compiler(const shader_source& of) {
    auto compiler = std::make_unique<spirv_cross::CompilerMSL>(of.module);
    spirv_cross::CompilerMSL::Options options;
    options.set_msl_version(of.made.made_for.version / 10, of.made.made_for.version % 10);
    options.buffer_size_buffer_index = of.made.buffer_sizes.value_or(0);
    compiler->set_msl_options(options);
    for (std::size_t i = 0; i < of.wanted.size(); ++i) {
        const placed_binding& p = of.made.bindings[i];
        spirv_cross::MSLResourceBinding place;
        place.stage = of.model();
        place.desc_set = of.wanted[i].set;
        place.binding = of.wanted[i].slot;
        place.count = 1;
        place.msl_buffer = place.msl_texture = p.number;
        place.msl_sampler = p.sampler.value_or(0);
        compiler->add_msl_resource_binding(place);
    }
    return compiler;
}

inline std::unique_ptr<spirv_cross::CompilerGLSL> glsl_compiler(const shader_source& of) {
    auto compiler = std::make_unique<spirv_cross::CompilerGLSL>(of.module);
    spirv_cross::CompilerGLSL::Options options;
    options.version = of.made.made_for.version;
    options.es = of.made.made_for.to == language::glsl_es;
    options.fragment.default_float_precision = spirv_cross::CompilerGLSL::Options::Highp;
    compiler->set_common_options(options);
    return compiler;
}

inline std::unique_ptr<spirv_cross::CompilerGLSL> compiler_of(const shader_source& of) {
    switch (of.made.made_for.to) {
    case language::hlsl:
        return hlsl_compiler(of);
    case language::msl:
        return msl_compiler(of);
    default:
        return glsl_compiler(of);
    }
}

/// The resources of a module, in the order of what it wants; one that nothing uses may be missing.
inline std::vector<std::optional<spirv_cross::Resource>>
resources_of(const spirv_cross::CompilerGLSL& compiler, const shader_source& of) {
    std::vector<std::optional<spirv_cross::Resource>> found(of.wanted.size());
    const spirv_cross::ShaderResources all = compiler.get_shader_resources();
    for (const auto* list :
         {&all.uniform_buffers, &all.storage_buffers, &all.sampled_images, &all.storage_images})
        for (const spirv_cross::Resource& each : *list)
            for (std::size_t i = 0; i < of.wanted.size(); ++i)
                if (compiler.get_decoration(each.id, spv::DecorationDescriptorSet) == of.wanted[i].set &&
                    compiler.get_decoration(each.id, spv::DecorationBinding) == of.wanted[i].slot)
                    found[i] = each;
    return found;
}

/// Whether hosts know a binding by the name of its block.
constexpr bool has_block_name(number_kind of) {
    return of == number_kind::b_register || of == number_kind::uniform_block ||
           of == number_kind::shader_storage;
}

/// @throws spirv_cross::CompilerError  where the language cannot what the module does
inline void write_text(shader_source& of) {
    translation& made = of.made;
    const auto compiler = compiler_of(of);
    const auto resources = resources_of(*compiler, of);
    compiler->rename_entry_point(compiler->get_entry_points_and_stages()[0].name, made.entry_point,
                                 of.model());
    if (of.model() == spv::ExecutionModelGLCompute)
        compiler->set_execution_mode(spv::ExecutionModeLocalSize, made.group_width, made.group_height, 1);
    for (std::size_t i = 0; i < resources.size(); ++i) {
        if (!resources[i])
            continue;
        if (is_glsl(made.made_for))
            compiler->set_decoration(resources[i]->id, spv::DecorationBinding, made.bindings[i].number);
        if (compiler->get_name(resources[i]->id).empty()) // of a buffer only the block has one
            compiler->set_name(resources[i]->id, of.wanted[i].identifier);
    }
    made.text = compiler->compile();
    if (made.made_for.to == language::msl) // which forbids some names
        made.entry_point = compiler->get_cleansed_entry_point_name(made.entry_point, of.model());
    for (std::size_t i = 0; i < resources.size(); ++i)
        if (resources[i])
            made.bindings[i].identifier = has_block_name(made.bindings[i].kind)
                                              ? compiler->get_remapped_declared_block_name(resources[i]->id)
                                              : compiler->get_name(resources[i]->id);
}

/// The first line, or in GLSL the second, says what the text was made of.
inline void write_origin(std::string& text, const effect_view& effect, const pass& which, const target& to) {
    const std::string line = "// " + std::string(effect.recipe) +
                             (effect.recipe.empty() ? "pass " : ", pass ") + std::string(which.name) +
                             ", as " + name_of(to) + "; crease " + std::string(version) +
                             ", SPDX-License-Identifier: MIT-0\n";
    text.insert(is_glsl(to) ? text.find('\n') + 1 : 0, line);
}

inline std::string entry_point_of(const pass& which, spirv::shader_stage of, const target& to) {
    if (is_glsl(to))
        return "main";
    if (!to.entry_point.empty())
        return to.entry_point;
    if (to.to == language::hlsl)
        return "main";
    return std::string(which.name) + (of == spirv::shader_stage::vertex ? "_vertex" : "_main");
}

/// @throws error  where the module is of another stage
inline spirv::shader_stage stage_of(const pass& which, const spirv::reflection& module, const target& to) {
    switch (module.model) {
    case spirv::execution_model::vertex:
        return spirv::shader_stage::vertex;
    case spirv::execution_model::fragment:
        return spirv::shader_stage::fragment;
    case spirv::execution_model::compute:
        return spirv::shader_stage::compute;
    default:
        throw error(title_of(which, to) + ": its module is no vertex, fragment or compute shader");
    }
}

inline unsigned size_along(const spirv::workgroup_axis& axis, const std::vector<placed_constant>& constants) {
    const auto set = std::ranges::find(constants, axis.id.value_or(~0u), &placed_constant::id);
    return set == constants.end() ? axis.size : static_cast<unsigned>(set->value);
}

/// Gives what a shader binds its numbers, and with them, where it `has_sizes`, the array of sizes of buffers.
inline void place_bindings(shader_source& of, const pass& which, bool has_sizes) {
    std::vector<wanted_binding> all = of.wanted;
    if (has_sizes)
        all.push_back({.name = buffer_sizes_name, .identifier = "", .kind = binding_kind::uniform_block});
    of.made.bindings = numbering(which, of.made.made_for).place(all);
    if (has_sizes) {
        of.made.buffer_sizes = of.made.bindings.back().number;
        of.made.bindings.pop_back();
    }
}

inline translation translated(const effect_view& effect, const pass& which,
                              std::span<const std::uint32_t> module, const target& to) {
    expect_version(which, to);
    const spirv::reflection found = spirv::reflect(module);
    const usage uses = usage_of(module);
    shader_source source;
    source.wanted = bindings_of(effect, which, found);
    expect_known(effect, source.wanted, to);
    expect_possible(which, found, uses, to);

    translation& made = source.made;
    made.made_for = to;
    made.stage = stage_of(which, found, to);
    made.entry_point = entry_point_of(which, made.stage, to);
    made.constants = constants_of(which, found, to);
    made.group_width = size_along(found.workgroup[0], made.constants);
    made.group_height = size_along(found.workgroup[1], made.constants);
    place_bindings(source, which, to.to == language::msl && uses.operations.contains(spv::OpArrayLength));
    source.module = to.frozen || !to.constants.empty() ? with_constants(module, made.constants, to.frozen)
                                                       : spirv::words(module.begin(), module.end());
    try {
        write_text(source);
    } catch (const spirv_cross::CompilerError& refused) {
        throw error(title_of(which, to) + ": SPIRV-Cross says: " + refused.what());
    }
    if (to.frozen)
        made.constants.clear();
    name_constants(made.text, made.constants);
    write_origin(made.text, effect, which, to);
    return made;
}

}

namespace crease::translate {

/// Translates the compute or fragment shader of a Vulkan pass.
/// @throws spirv::error  with a sentence that names the pass, the language and what it cannot, or what the
///                       effect has not that `to` names
inline translation shader(const effect_view& effect, const pass& which, const target& to) {
    detail::expect_whole(which, to);
    return detail::translated(effect, which, spirv::compile(which), to);
}

/// Translates a module that holds a pass: what `spirv::compile` gave of it, or a host's own shader around the
/// functions of a pass that has no `main`, of the stage `functions` or `geometry`.
/// @param module  valid SPIR-V
/// @throws spirv::error  as above
inline translation module(const effect_view& effect, const pass& which, std::span<const std::uint32_t> module,
                          const target& to) {
    return detail::translated(effect, which, module, to);
}

/// Translates the vertex shader of a fragment pass; it binds nothing.
/// @throws spirv::error  as above
inline translation vertex_shader(const effect_view& effect, const pass& which, const target& to) {
    pass alone = which;
    alone.bindings = {};
    alone.constants = {};
    return detail::translated(effect, alone, spirv::compile_vertex(which), to);
}

}
