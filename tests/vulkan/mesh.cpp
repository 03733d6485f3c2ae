// SPDX-License-Identifier: MIT
#include <crease/spirv/compile.hpp>
#include <crease/vulkan/mesh.hpp>

#include "sentence.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

using namespace crease;

namespace {

constexpr piece version{"version", "#version 450\n"};

/// A vertex shader that takes these attributes.
spirv::words taking(std::string_view attributes, std::string_view position) {
    const std::string main = "void main() { gl_Position = " + std::string(position) + "; }\n";
    const piece pieces[] = {version, {"attributes", attributes}, {"main", main}};
    return spirv::compile(pieces, spirv::shader_stage::vertex);
}

}

TEST_CASE("a mesh is of whole triangles, at least one") {
    vulkan::device& device = validated_device();
    const auto said = [&](std::size_t numbers) {
        return sentence_of([&] { vulkan::mesh(device, std::vector<float>(numbers)); });
    };
    CHECK(said(0) == "a mesh takes 18 numbers a triangle, not 0 in all");
    CHECK(said(17) == "a mesh takes 18 numbers a triangle, not 17 in all");
    CHECK(said(18) == "");
    CHECK(said(24) == "a mesh takes 18 numbers a triangle, not 24 in all");
    CHECK(vulkan::mesh(device, std::vector<float>(36)).vertex_count() == 6);
}

TEST_CASE("a pipeline reads normals where the vertex shader takes them") {
    const std::string position = "layout(location = 0) in vec3 position;\n",
                      both = position + "layout(location = 1) in vec3 normal;\n";
    CHECK(
        vulkan::detail::mesh_input(taking(position, "vec4(position, 1.0)")).vertexAttributeDescriptionCount ==
        1);
    CHECK(vulkan::detail::mesh_input(taking(both, "vec4(position + normal, 1.0)"))
              .vertexAttributeDescriptionCount == 2);
}
