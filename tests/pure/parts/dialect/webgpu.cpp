// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <string_view>

TEST_CASE("the webgpu dialect has images without samplers, and constants that are fixed") {
    using namespace crease;
    using of_webgpu = effect<directions<>, single_layer, hbao, bilateral<>, webgpu_glsl>;
    const std::string_view text = of_webgpu::source<0>();
    CHECK(has_version(text, "#version 450\n#extension GL_EXT_samplerless_texture_functions : require\n"));
    CHECK(contains(text, "layout(set = 0, binding = 1) uniform texture2D crease_depth;\n"));
    CHECK(contains(text, "#define textureLod(image, at, level) texelFetch("));
    CHECK(contains(text, "#define crease_radius crease_given.radius\n")); // naga would leave it at 0
    CHECK(contains(text, "void main() {\n    crease_view = crease_view_of(crease_view_index);\n"));
    CHECK_FALSE(contains(text, "sampler2D"));
    CHECK_FALSE(contains(text, "constant_id"));
    CHECK_FALSE(contains(text, "local_size_x_id"));
    CHECK(of_webgpu::passes[0].dialect == dialect_kind::webgpu);
    CHECK(of_webgpu::resources[of_webgpu::resources.size() - 1].texels == format::rgba8_unorm);
    CHECK_FALSE(of_webgpu::features.extended_storage_formats);
}

TEST_CASE("webgpu writes the size of a workgroup as numbers, which WGSL does not tell") {
    using namespace crease;
    using of_webgpu = effect<directions<>, single_layer, hbao, compute_columns<16, 8>, webgpu_glsl>;
    using of_vulkan = effect<directions<>, single_layer, hbao, compute_columns<16, 8>>;
    CHECK(contains(of_webgpu::source<0>(), "#define crease_group_size uvec3(16, 8, 1)\n"));
    CHECK(contains(of_vulkan::source<0>(), "#define crease_group_size gl_WorkGroupSize\n"));
}

TEST_CASE("what webgpu cannot is refused by name") {
    CHECK(contains(crease::recipe("directions/stochastic_layers/hbao/webgpu").error(),
                   "(multisampled, webgpu)"));
    CHECK(contains(crease::recipe("box_area/summed_area/unsharp_mask/subgroup_scan/webgpu").error(),
                   "(subgroup_scan, webgpu)"));
    CHECK(crease::recipe("directions/depth_pyramid/hbao/webgpu"));
}
