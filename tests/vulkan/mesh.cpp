// SPDX-License-Identifier: MIT
#include <crease/spirv/compile.hpp>
#include <crease/vulkan/mesh.hpp>

#include "sentence.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

#include <set>

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

TEST_CASE("a mesh has a colour for each vertex, or none") {
    vulkan::device& device = validated_device();
    const std::vector<float> triangles(36);
    const auto said = [&](std::size_t numbers) {
        return sentence_of([&] { vulkan::mesh(device, triangles, std::vector<float>(numbers)); });
    };
    CHECK(said(0) == "");
    CHECK(said(24) == "");
    CHECK(said(12) == "a mesh takes 12 numbers of colour a triangle, 24 in all and not 12");
    CHECK(said(25) == "a mesh takes 12 numbers of colour a triangle, 24 in all and not 25");
    CHECK_FALSE(vulkan::mesh(device, triangles).has_colours());
    CHECK(vulkan::mesh(device, triangles, std::vector<float>(24)).has_colours());
}

TEST_CASE("a pipeline reads normals and colours where the vertex shader takes them") {
    const std::string position = "layout(location = 0) in vec3 position;\n",
                      normal = "layout(location = 1) in vec3 normal;\n",
                      colour = "layout(location = 2) in vec4 colour;\n";
    const auto locations = [](const std::string& attributes, const std::string& sum) {
        const VkPipelineVertexInputStateCreateInfo input =
            vulkan::detail::mesh_input(taking(attributes, sum));
        CHECK(input.vertexBindingDescriptionCount == (sum.find("colour") != sum.npos ? 2 : 1));
        std::set<std::uint32_t> read;
        for (std::uint32_t i = 0; i < input.vertexAttributeDescriptionCount; ++i)
            read.insert(input.pVertexAttributeDescriptions[i].location);
        return read;
    };
    using numbers = std::set<std::uint32_t>;
    CHECK(locations(position, "vec4(position, 1.0)") == numbers{0});
    CHECK(locations(position + normal, "vec4(position + normal, 1.0)") == numbers{0, 1});
    CHECK(locations(position + colour, "vec4(position, 1.0) + colour") == numbers{0, 2});
    CHECK(locations(position + normal + colour, "vec4(position + normal, 1.0) + colour") == numbers{0, 1, 2});
}
