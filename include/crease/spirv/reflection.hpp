// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/resource.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace crease::spirv {

/// What a descriptor binding of a module is.
enum class binding_kind : unsigned char {
    uniform_block,
    storage_block,
    sampled_image, ///< an image with its sampler
    storage_image,
    other ///< a separate image or sampler, a texel buffer, ...
};

/// The type of a number.
enum class scalar_kind : unsigned char { none, boolean, signed_integer, unsigned_integer, floating_point };

/// A member of a block.
struct block_member {
    std::string name;         ///< in the GLSL
    std::uint32_t offset = 0; ///< bytes
};

/// A descriptor binding.
struct bound_resource {
    std::uint32_t set = 0;  ///< descriptor set
    std::uint32_t slot = 0; ///< binding
    std::string name;       ///< of the variable; of a block its own, whatever the instance is called
    binding_kind kind = binding_kind::other;   ///< what the descriptor is
    scalar_kind component = scalar_kind::none; ///< what an image's texels are read or written as
    format texels = format::none;              ///< of a storage image, where crease knows its format
    bool arrayed = false;                      ///< an array image
    bool multisampled = false;                 ///< a multisampled image
    bool readable = true;                      ///< whether the module may read it
    bool writable = true;              ///< whether it may write it; never a sampled image or a uniform block
    std::vector<block_member> members; ///< of a block
    std::uint32_t size = 0;            ///< of a block: bytes, rounded up to 16 for a uniform block
};

/// A specialization constant.
struct specialization_constant {
    std::uint32_t id = 0; ///< constant_id
    std::string name; ///< empty where it is a workgroup size that only `local_size_x_id` and the like name
    scalar_kind type = scalar_kind::none; ///< its type
    std::uint32_t value = 0;              ///< the default's bits
};

/// The workgroup size along one axis.
struct workgroup_axis {
    std::uint32_t size = 0;          ///< invocations; the default where `id` is set
    std::optional<std::uint32_t> id; ///< of the specialization constant that sets it
};

/// A colour output of a fragment shader.
struct colour_output {
    std::uint32_t location = 0; ///< of the attachment
    std::string name;           ///< in the GLSL
};

/// What runs a module's entry point.
enum class execution_model : unsigned char { vertex, fragment, compute, other };

/// What a module says of its interface.
struct reflection {
    execution_model model = execution_model::other; ///< what runs it
    std::string entry_point;                        ///< its name, "main"
    std::vector<bound_resource> bindings;           ///< sorted by set and slot
    std::vector<specialization_constant> constants; ///< sorted by id
    std::array<workgroup_axis, 3> workgroup;        ///< x, y, z of a compute shader
    std::vector<colour_output> colours;             ///< of a fragment shader, sorted by location
    std::vector<std::uint32_t> attributes;          ///< locations of a vertex shader's inputs, sorted
};

}
