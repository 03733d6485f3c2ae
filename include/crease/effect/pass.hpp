// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/access.hpp>
#include <crease/effect/array_view.hpp>
#include <crease/effect/extent.hpp>

#include <cstdint>
#include <string_view>

namespace crease {

/// What a pass runs as.
enum class stage_kind : unsigned char {
    compute,   ///< compute invocations
    fragment,  ///< one triangle that covers the output
    functions, ///< no `main`: functions that an engine's own shader calls
    geometry   ///< no `main`: functions that the fragment shader of the host's geometry calls
};

/// Which GLSL a pass is written in.
enum class dialect_kind : unsigned char {
    vulkan,  ///< GLSL 450 for Vulkan 1.1 and up
    opengl,  ///< GLSL 430 for OpenGL 4.3 and up
    glsl_es, ///< GLSL ES 3.00 for WebGL 2 and OpenGL ES 3.0, or 3.10 for OpenGL ES 3.1 and up
    webgpu   ///< GLSL 450 of which naga makes WGSL: images without samplers, constants that are fixed
};

/// How a compute pass covers its output.
enum class dispatch : unsigned char {
    texels, ///< one invocation for each texel
    rows,   ///< a workgroup as wide as the image, whatever its width: (1, height / group height, 1)
    columns ///< a workgroup as high as the image, whatever its height: (width / group width, 1, 1)
};

/// One resource that a pass uses, and where it is bound.
struct binding {
    /// The `level` of a binding of a whole image.
    static constexpr unsigned all_levels = ~0u;

    std::string_view name; ///< "parameters", "input", "output" or the resource's; in GLSL crease_<name>
    unsigned resource = 0; ///< index into the effect's resources
    access how = access::uniform; ///< what the pass does with it
    unsigned set = 0;             ///< Vulkan descriptor set; 0 in OpenGL
    unsigned slot = 0; ///< Vulkan binding; in OpenGL the unit, counted for each of blocks, textures, images
                       ///< and buffers; GLSL ES 3.00 has no bindings, and a host sets it by the name
    unsigned level = all_levels; ///< of an image with mip levels: the one that is bound
};

/// A number of a part: a specialization constant in Vulkan GLSL, a `const int` in other GLSL.
struct constant {
    std::string_view part;   ///< e.g. "directions"
    std::string_view number; ///< e.g. "steps"; the GLSL identifier is crease_directions_steps
    unsigned id = 0;         ///< constant_id
    int value = 0;           ///< the default
};

/// A piece of a pass's text, with the file and the line in it that an error message names.
struct piece {
    std::string_view name;   ///< path below templates/crease, e.g. "estimator/hbao.glsl"; or "interface"
    std::string_view text;   ///< whole lines
    unsigned first_line = 1; ///< line of the file at which `text` begins
};

/// One shader of an effect: its text, and all that a renderer must know to run it.
///
/// A geometry pass has no `main`: its text is `void crease_capture(vec3 anchor)` and what it calls, for the
/// fragment shader of geometry that the host draws without culling.
struct pass {
    std::string_view name;                       ///< e.g. "visibility", "bilateral_x"
    stage_kind stage = stage_kind::compute;      ///< what it runs as
    dialect_kind dialect = dialect_kind::vulkan; ///< which GLSL it is
    array_view<const piece> pieces;              ///< in order; joined they are the GLSL program
    array_view<const piece> vertex_pieces;       ///< the vertex shader of a fragment pass; empty otherwise
    array_view<const binding> bindings; ///< the block of parameters first, where it is used; outputs last
    array_view<const constant>
        constants; ///< of a compute pass the first two are the workgroup's width and height
    extent size;   ///< of the outputs; one of a mip level that the image has not is left out
    dispatch covers = dispatch::texels;      ///< of a compute pass, which workgroups run
    unsigned view = 0;                       ///< index of the camera whose picture it makes
    bool takes_surfaces = false;             ///< of a geometry pass, whether its function is
                                             ///< `void crease_capture(vec3 anchor, vec3 normal, vec4 color)`
    array_view<const std::uint32_t> spirv{}; ///< words made beforehand, as by `crease_add_shader`, in place
                                             ///< of the pieces; empty: compile those
    array_view<const std::uint32_t> vertex_spirv{}; ///< the same of a fragment pass's vertex shader

    /// Width of the workgroup in invocations; 0 where the pass is not compute.
    constexpr unsigned group_width() const {
        return stage == stage_kind::compute ? static_cast<unsigned>(constants[0].value) : 0;
    }
    /// Height of the workgroup in invocations; 0 where the pass is not compute.
    constexpr unsigned group_height() const {
        return stage == stage_kind::compute ? static_cast<unsigned>(constants[1].value) : 0;
    }

    /// Whether a geometry pass draws to a multisampled depth attachment, with the host's depth test and clear
    /// value; the shader sets the sample mask, and the depth too where the resource is not `centred`. Other
    /// geometry passes draw without attachments and without a depth test.
    constexpr bool to_attachment() const { return bindings.back().how == access::attachment; }
};

}
