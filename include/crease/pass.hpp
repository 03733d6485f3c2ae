// SPDX-License-Identifier: MIT
#pragma once

#include <crease/array_view.hpp>
#include <crease/glsl_file.hpp>
#include <crease/parameters.hpp>
#include <crease/resource.hpp>

namespace crease {

/// What a pass runs as.
enum class stage_kind : unsigned char {
    compute,  ///< compute invocations
    fragment, ///< one triangle that covers the output
    functions ///< no `main`: functions that an engine's own shader calls
};

enum class dialect_kind : unsigned char {
    vulkan, ///< GLSL 450 for Vulkan 1.1 and up
    opengl  ///< GLSL 430 for OpenGL 4.3 and up
};

/// How a compute pass covers its output.
enum class dispatch : unsigned char {
    texels, ///< one invocation for each texel
    rows,   ///< a workgroup as wide as the image, whatever its width: (1, height / group height, 1)
    columns ///< a workgroup as high as the image, whatever its height: (width / group width, 1, 1)
};

/// One resource that a pass uses, and where it is bound.
struct binding {
    std::string_view name; ///< "parameters", "input", "output" or the resource's; in GLSL crease_<name>
    unsigned resource = 0; ///< index into the effect's resources
    access how = access::uniform;
    unsigned set = 0; ///< Vulkan descriptor set; 0 in OpenGL
    unsigned slot =
        0; ///< Vulkan binding; in OpenGL the unit, counted for each of blocks, textures and images
};

/// A number of a part: a specialization constant in Vulkan GLSL, a `const int` in OpenGL GLSL.
struct constant {
    std::string_view part;   ///< e.g. "directions"
    std::string_view number; ///< e.g. "steps"; the GLSL identifier is crease_directions_steps
    unsigned id = 0;         ///< constant_id
    int value = 0;           ///< the default
};

/// A piece of a pass's text, with the name that an error message uses.
using piece = glsl_file;

/// One shader of an effect: its text, and all that a renderer must know to run it.
struct pass {
    std::string_view name; ///< e.g. "visibility", "bilateral_x"
    stage_kind stage = stage_kind::compute;
    dialect_kind dialect = dialect_kind::vulkan;
    array_view<const piece> pieces;        ///< in order; joined they are the GLSL program
    array_view<const piece> vertex_pieces; ///< the vertex shader of a fragment pass; empty otherwise
    array_view<const binding> bindings;    ///< the first is the block of parameters, the last are the outputs
    array_view<const constant>
        constants; ///< of a compute pass the first two are the workgroup's width and height
    extent size;   ///< of the outputs
    dispatch covers = dispatch::texels;

    /// Workgroup width and height in invocations; 0 where the pass is not compute.
    constexpr unsigned group_width() const {
        return stage == stage_kind::compute ? static_cast<unsigned>(constants[0].value) : 0;
    }
    constexpr unsigned group_height() const {
        return stage == stage_kind::compute ? static_cast<unsigned>(constants[1].value) : 0;
    }
};

/// What a host adds to its geometry pass, so that it fills a resource that an effect reads: functions for its
/// fragment shader, and the state that they need. The geometry is drawn without culling and before the first
/// pass.
struct capture {
    std::string_view name; ///< e.g. "layers"
    dialect_kind dialect = dialect_kind::vulkan;
    array_view<const piece> pieces;     ///< GLSL without `main`: `void crease_capture(vec3 anchor)`
    array_view<const binding> bindings; ///< the first is the block of parameters; the last is what it fills
    array_view<const constant> constants;
    extent size; ///< of what it fills

    /// Whether it fills a multisampled depth attachment, with the host's depth test and clear value, whose
    /// sample mask the shader sets, and the depth too where the resource's samples are not `centred`. Else it
    /// draws without attachments and without depth test.
    constexpr bool to_attachment() const { return bindings.back().how == access::attachment; }
};

/// Device features that an effect requires beyond Vulkan 1.1 or OpenGL 4.3.
struct device_features {
    /// Vulkan: shaderStorageImageExtendedFormats (storing to R8, RG32). Core in OpenGL 4.3.
    bool extended_storage_formats = false;
    /// Vulkan: fragmentStoresAndAtomics. Core in OpenGL 4.3.
    bool fragment_stores_and_atomics = false;
    /// Arithmetic of subgroups in compute shaders.
    bool subgroup_arithmetic = false;
    /// Sums of the sample counts of depth images that are drawn to and sampled, e.g. 4 | 8; 0: none.
    unsigned depth_samples = 0;
    /// Of these, those whose samples can be placed at the centre of a texel: Vulkan's
    /// VK_EXT_sample_locations.
    unsigned centred_depth_samples = 0;

    /// Whether a device that has these features can run what requires `wanted`.
    constexpr bool cover(const device_features& wanted) const {
        return (extended_storage_formats || !wanted.extended_storage_formats) &&
               (fragment_stores_and_atomics || !wanted.fragment_stores_and_atomics) &&
               (subgroup_arithmetic || !wanted.subgroup_arithmetic) &&
               (depth_samples & wanted.depth_samples) == wanted.depth_samples &&
               (centred_depth_samples & wanted.centred_depth_samples) == wanted.centred_depth_samples;
    }
    /// Adds what another effect, pass or part requires.
    constexpr device_features& operator|=(const device_features& more) {
        extended_storage_formats |= more.extended_storage_formats;
        fragment_stores_and_atomics |= more.fragment_stores_and_atomics;
        subgroup_arithmetic |= more.subgroup_arithmetic;
        depth_samples |= more.depth_samples;
        centred_depth_samples |= more.centred_depth_samples;
        return *this;
    }
    constexpr bool operator==(const device_features&) const = default;
};

/// An effect as data, whether it was composed at compile time or at run time: all a renderer needs to run it.
/// Views static storage, or that of the `composition` it came from.
struct effect_view {
    array_view<const capture> captures;   ///< what the host's geometry pass fills first; empty for most
    array_view<const pass> passes;        ///< in the order of execution
    array_view<const resource> resources; ///< resource 0 is the block of parameters; the outputs come last
    device_features features;
    parameters defaults; ///< the settings as the parts recommend them; no view in it yet
};

}
