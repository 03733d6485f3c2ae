// SPDX-License-Identifier: MIT
#pragma once

#include <crease/spirv/instructions.hpp>
#include <crease/spirv/reflection.hpp>

#include <algorithm>
#include <span>
#include <tuple>

namespace crease::spirv::detail {

constexpr format format_of(spv::ImageFormat of) {
    switch (of) {
    case spv::ImageFormatR8:
        return format::r8_unorm;
    case spv::ImageFormatRgba8:
        return format::rgba8_unorm;
    case spv::ImageFormatR32ui:
        return format::r32_uint;
    case spv::ImageFormatR32f:
        return format::r32_float;
    case spv::ImageFormatRgba16f:
        return format::rgba16_float;
    case spv::ImageFormatRg32ui:
        return format::rg32_uint;
    case spv::ImageFormatRgba32ui:
        return format::rgba32_uint;
    case spv::ImageFormatRg32f:
        return format::rg32_float;
    case spv::ImageFormatRgba32f:
        return format::rgba32_float;
    default:
        return format::none;
    }
}

constexpr execution_model model_of(spv::ExecutionModel of) {
    switch (of) {
    case spv::ExecutionModelVertex:
        return execution_model::vertex;
    case spv::ExecutionModelFragment:
        return execution_model::fragment;
    case spv::ExecutionModelGLCompute:
        return execution_model::compute;
    default:
        return execution_model::other;
    }
}

/// Turns a module's instructions into what they say of its interface.
class reflector {
public:
    explicit reflector(const instructions& module) : module_(module) {}

    reflection all() const {
        reflection found;
        for (const instruction& each : module_.all) {
            if (each.code == spv::OpEntryPoint) {
                found.model = model_of(static_cast<spv::ExecutionModel>(each[1]));
                found.entry_point = each.text(3);
            } else if (each.code == spv::OpExecutionMode && each[2] == spv::ExecutionModeLocalSize) {
                for (std::size_t axis = 0; axis < 3; ++axis)
                    found.workgroup[axis] = {each[3 + axis], std::nullopt};
            } else if (each.code == spv::OpVariable) {
                add_variable(found, each);
            } else if (const auto id = module_.decoration(each.result, spv::DecorationSpecId);
                       each.result && id) {
                found.constants.push_back(constant(each, *id));
            }
        }
        read_workgroup_constant(found);
        std::ranges::sort(found.bindings, {}, [](const auto& b) { return std::tuple(b.set, b.slot); });
        std::ranges::stable_sort(found.constants, {}, &specialization_constant::id);
        std::ranges::sort(found.colours, {}, &colour_output::location);
        std::ranges::sort(found.attributes);
        return found;
    }

private:
    const instructions& module_;

    bool has(std::uint32_t id, spv::Decoration which, int member = -1) const {
        return module_.decoration(id, which, member).has_value();
    }

    scalar_kind scalar(std::uint32_t type) const {
        const instruction& t = module_.of(type);
        switch (t.code) {
        case spv::OpTypeBool:
            return scalar_kind::boolean;
        case spv::OpTypeInt:
            return t[3] ? scalar_kind::signed_integer : scalar_kind::unsigned_integer;
        case spv::OpTypeFloat:
            return scalar_kind::floating_point;
        default:
            return scalar_kind::none;
        }
    }

    specialization_constant constant(const instruction& each, std::uint32_t id) const {
        const bool truth = each.code == spv::OpSpecConstantTrue;
        return {id, module_.name_of(each.result), scalar(each.type),
                each.code == spv::OpSpecConstant ? each[3] : truth};
    }

    void add_variable(reflection& found, const instruction& variable) const {
        const auto storage = static_cast<spv::StorageClass>(variable[3]);
        const auto location = module_.decoration(variable.result, spv::DecorationLocation);
        if (storage == spv::StorageClassOutput && location && found.model == execution_model::fragment)
            found.colours.push_back({*location, module_.name_of(variable.result)});
        if (storage == spv::StorageClassInput && location && found.model == execution_model::vertex)
            found.attributes.push_back(*location);
        if (const auto slot = module_.decoration(variable.result, spv::DecorationBinding))
            found.bindings.push_back(bound(variable, storage, *slot));
    }

    bound_resource bound(const instruction& variable, spv::StorageClass storage, std::uint32_t slot) const {
        bound_resource b{.slot = slot, .name = module_.name_of(variable.result), .members = {}};
        b.set = module_.decoration(variable.result, spv::DecorationDescriptorSet).value_or(0);
        b.readable = !has(variable.result, spv::DecorationNonReadable);
        b.writable = !has(variable.result, spv::DecorationNonWritable);
        const instruction* type = &module_.of(module_.of(variable.type)[3]);
        while (type->code == spv::OpTypeArray || type->code == spv::OpTypeRuntimeArray)
            type = &module_.of((*type)[2]);
        const bool with_sampler = type->code == spv::OpTypeSampledImage;
        if (with_sampler)
            type = &module_.of((*type)[2]);
        if (type->code == spv::OpTypeStruct)
            describe_block(b, *type, storage);
        else if (type->code == spv::OpTypeImage)
            describe_image(b, *type, with_sampler);
        return b;
    }

    static constexpr std::uint32_t storage_use = 2; // the operand "Sampled" of a storage image

    void describe_image(bound_resource& b, const instruction& image, bool with_sampler) const {
        b.component = scalar(image[2]);
        b.arrayed = image[5] != 0;
        b.multisampled = image[6] != 0;
        b.texels = format_of(static_cast<spv::ImageFormat>(image[8]));
        if (static_cast<spv::Dim>(image[3]) == spv::DimBuffer)
            return;
        if (with_sampler)
            b.kind = binding_kind::sampled_image;
        else if (image[7] == storage_use)
            b.kind = binding_kind::storage_image;
        if (b.kind != binding_kind::storage_image)
            b.writable = false;
    }

    void describe_block(bound_resource& b, const instruction& block, spv::StorageClass storage) const {
        const bool uniform = storage == spv::StorageClassUniform && has(block.result, spv::DecorationBlock);
        b.kind = uniform ? binding_kind::uniform_block : binding_kind::storage_block;
        if (uniform)
            b.writable = false;
        else
            read_access(b, block);
        b.name = module_.name_of(block.result); // by which a host knows it
        for (std::uint32_t i = 0; i + 2 < block.operands.size(); ++i) {
            const int member = static_cast<int>(i);
            const auto name = module_.member_names.find({block.result, i});
            const std::uint32_t offset =
                module_.decoration(block.result, spv::DecorationOffset, member).value_or(0);
            b.members.push_back({name == module_.member_names.end() ? "" : name->second, offset});
            const auto matrix_stride = module_.decoration(block.result, spv::DecorationMatrixStride, member);
            b.size = std::max(b.size, offset + size_of(block[2 + i], matrix_stride.value_or(0)));
        }
        if (uniform)
            b.size = (b.size + 15) / 16 * 16;
    }

    /// Of a storage block the members say how it is accessed.
    void read_access(bound_resource& b, const instruction& block) const {
        bool readable = false, writable = false;
        for (std::uint32_t i = 0; i + 2 < block.operands.size(); ++i) {
            readable = readable || !has(block.result, spv::DecorationNonReadable, static_cast<int>(i));
            writable = writable || !has(block.result, spv::DecorationNonWritable, static_cast<int>(i));
        }
        b.readable = b.readable && readable;
        b.writable = b.writable && writable;
    }

    /// Bytes of a type within a block; of a runtime array 0.
    std::uint32_t size_of(std::uint32_t type, std::uint32_t matrix_stride) const {
        const instruction& t = module_.of(type);
        switch (t.code) {
        case spv::OpTypeInt:
        case spv::OpTypeFloat:
            return t[2] / 8;
        case spv::OpTypeVector:
            return t[3] * size_of(t[2], 0);
        case spv::OpTypeMatrix:
            return t[3] * matrix_stride;
        case spv::OpTypeArray:
            return module_.of(t[3])[3] * module_.decoration(type, spv::DecorationArrayStride).value_or(0);
        case spv::OpTypeStruct:
            return struct_size(t);
        default:
            return 0;
        }
    }

    std::uint32_t struct_size(const instruction& block) const {
        bound_resource nested{.name = {}, .members = {}};
        describe_block(nested, block, spv::StorageClassStorageBuffer);
        return nested.size;
    }

    /// A workgroup size by specialization ids is a constant with the decoration WorkgroupSize, which
    /// overrides the execution mode.
    void read_workgroup_constant(reflection& found) const {
        for (const auto& [key, builtin] : module_.decorations)
            if (key.decoration == spv::DecorationBuiltIn && builtin == spv::BuiltInWorkgroupSize &&
                key.member < 0)
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const instruction& size = module_.of(module_.of(key.id)[3 + axis]);
                    found.workgroup[axis] = {size[3], module_.decoration(size.result, spv::DecorationSpecId)};
                }
    }
};

}

namespace crease::spirv {

/// Reads from a module what it binds, its specialization constants, its workgroup size and its colour
/// outputs.
/// @throws error  where it is not SPIR-V
inline reflection reflect(std::span<const std::uint32_t> module) {
    const detail::instructions read = detail::read(module);
    return detail::reflector(read).all();
}

}
