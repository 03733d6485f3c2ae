// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/descriptors.hpp>
#include <crease/vulkan/mesh.hpp>
#include <crease/vulkan/pipeline.hpp>
#include <crease/vulkan/render_target.hpp>
#include <crease/vulkan/shaders.hpp>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace crease::vulkan {

/// What a host brings to a geometry pass; no GLSL where its SPIR-V is among the options of the runner.
struct geometry_shaders {
    std::span<const piece> vertex;         ///< GLSL; `layout(location = 0) in vec3` is the position, 1 the
                                           ///< normal, `in vec4` at 2 the colour
    std::span<const piece> fragment;       ///< GLSL without `#version`; its main calls `crease_capture`
    std::uint32_t push_constant_bytes = 0; ///< that both shaders may read; a multiple of 4, at most 128
    bool reversed_depth = false;           ///< the greatest device depth is the nearest
};

/// Compiles a geometry pass, which the host's shaders make whole.
/// @throws spirv::error  where they do not compile
inline pass_shaders compile(const pass& which, const geometry_shaders& host) {
    std::vector<piece> whole{{"version", "#version 450\n"}};
    whole.insert(whole.end(), which.pieces.begin(), which.pieces.end());
    whole.insert(whole.end(), host.fragment.begin(), host.fragment.end());
    return {spirv::compile(whole, spirv::shader_stage::fragment,
                           "the geometry pass '" + std::string(which.name) + "'"),
            spirv::compile(host.vertex, spirv::shader_stage::vertex, "the vertex shader")};
}

}

namespace crease::vulkan::detail {

/// A geometry pass with all that is needed to record it. Knows nothing of what is captured.
class prepared_geometry {
public:
    /// @param attachment  what the pass draws to; null where it has no attachment
    /// @param size        of what it fills, texels
    /// @param values      of the pass's constants, in their order
    /// @param ways        round in which histories can lie
    /// @param shaders     SPIR-V, as compile() gives it
    /// @throws error  where the device lacks a limit or memory
    prepared_geometry(device& on, const pass& of, std::span<const resource> resources, image* attachment,
                      VkExtent2D size, const geometry_shaders& host, const pass_shaders& shaders,
                      std::span<const std::int32_t> values, std::size_t ways)
        : pass_(of), push_bytes_(host.push_constant_bytes), clear_depth_(host.reversed_depth ? 0.0f : 1.0f),
          descriptors_(on, of.bindings, resources, VK_SHADER_STAGE_FRAGMENT_BIT, ways, push_bytes_,
                       geometry_stages),
          input_(mesh_input(shaders.vertex)) {
        expect_push_size(on, push_bytes_);
        target_ = std::make_unique<render_target>(on, std::vector<image*>(), attachment, size,
                                                  earlier_content::cleared);
        make_pipeline(on, shaders, specialization(of.constants, values));
    }

    /// What is drawn from now on. The mesh must outlive the runs.
    /// @throws error  where there are not as many push constants as the shaders say, or no colours that they
    /// take
    void set(const mesh& triangles, std::span<const std::byte> push_constants) {
        expect_push_constants(push_constants, push_bytes_);
        expect_colours(triangles, input_);
        triangles_ = &triangles;
        pushed_.assign(push_constants.begin(), push_constants.end());
    }

    void write_descriptors(const bound_resources& bound, VkSampler sampler, std::size_t way) const {
        descriptors_.write(bound, sampler, way);
    }

    void record(VkCommandBuffer commands, const bound_resources& bound, std::size_t way) const {
        prepare_for(commands, pass_.bindings, bound, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT);
        target_->begin(commands, clear_depth_);
        descriptors_.bind(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, way);
        draw_mesh(commands, pipeline_, descriptors_.layout(), *triangles_, pushed_);
        target_->end(commands);
    }

private:
    pass pass_;
    std::uint32_t push_bytes_;
    float clear_depth_;
    descriptors descriptors_;
    std::unique_ptr<render_target> target_;
    VkPipelineVertexInputStateCreateInfo input_;
    owned_pipeline pipeline_;
    const mesh* triangles_ = nullptr;
    std::vector<std::byte> pushed_;

    void make_pipeline(const device& on, const pass_shaders& shaders, const specialization& constants) {
        pipeline_ = make_graphics_pipeline(
            on, {.vertex = shaders.vertex,
                 .fragment = shaders.main,
                 .layout = descriptors_.layout(),
                 .target = target_.get(),
                 .constants = &constants,
                 .vertex_input = input_,
                 .nearer = clear_depth_ == 0 ? VK_COMPARE_OP_GREATER : VK_COMPARE_OP_LESS});
    }
};

}
