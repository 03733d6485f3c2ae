// SPDX-License-Identifier: MIT
#include <crease/spirv.hpp>

#include "little_effect.hpp"

#include <doctest/doctest.h>

using namespace crease;
using spirv::binding_kind;

TEST_CASE("a compute shader's interface") {
    const spirv::reflection r = spirv::reflect(spirv::compile(little::scale));
    CHECK(r.model == spirv::execution_model::compute);
    CHECK(r.entry_point == "main");
    CHECK(r.colours.empty());

    REQUIRE(r.bindings.size() == 3);
    CHECK(r.bindings[0].name == "crease_parameters");
    CHECK(r.bindings[0].kind == binding_kind::uniform_block);
    CHECK(r.bindings[0].size == little::effect.block_size());
    REQUIRE(r.bindings[0].members.size() == 7);
    CHECK(r.bindings[0].members[2].name == "radius");
    CHECK(r.bindings[0].members[2].offset == 160);
    CHECK(!r.bindings[0].writable);

    CHECK(r.bindings[1].name == "crease_depth");
    CHECK(r.bindings[1].kind == binding_kind::sampled_image);
    CHECK(r.bindings[1].component == spirv::scalar_kind::floating_point);
    CHECK(!r.bindings[1].writable);

    CHECK(r.bindings[2].name == "crease_output");
    CHECK(r.bindings[2].slot == 2);
    CHECK(r.bindings[2].kind == binding_kind::storage_image);
    CHECK(r.bindings[2].texels == format::r32_float);
    CHECK(r.bindings[2].writable);
    CHECK(!r.bindings[2].readable);

    REQUIRE(r.constants.size() == 3);
    CHECK(r.constants[2].name == "crease_scale_gain");
    CHECK(r.constants[2].type == spirv::scalar_kind::signed_integer);
    CHECK(r.constants[2].value == 2);
    CHECK(r.workgroup[0].size == 8);
    CHECK(r.workgroup[0].id == 0u);
    CHECK(r.workgroup[1].size == 4);
    CHECK(r.workgroup[1].id == 1u);
    CHECK(r.workgroup[2].size == 1);
    CHECK(!r.workgroup[2].id);
}

TEST_CASE("a fragment shader's interface") {
    const spirv::reflection r = spirv::reflect(spirv::compile(little::spread));
    CHECK(r.model == spirv::execution_model::fragment);
    REQUIRE(r.colours.size() == 1);
    CHECK(r.colours[0].location == 0);
    CHECK(r.colours[0].name == "crease_output");
    CHECK(r.bindings.size() == 2);
}

TEST_CASE("kinds of binding, image shapes and block sizes") {
    const piece pieces[] = {little::version, {"kinds.glsl", R"(
layout(local_size_x = 4, local_size_y = 2, local_size_z = 3) in;
struct inner { vec3 a; float b; };
layout(std140, set = 1, binding = 0) uniform numbers { mat3 m; float f[3]; inner s; float last; };
layout(std430, set = 1, binding = 1) readonly buffer nodes { uvec2 node[]; };
layout(set = 1, binding = 2) uniform usampler2DArray keys;
layout(set = 1, binding = 3) uniform sampler2DMS samples;
layout(set = 0, binding = 9, r32ui) uniform uimage2DArray heads;
layout(set = 0, binding = 8, rgba16f) readonly uniform image2D given;
layout(set = 0, binding = 7) uniform texture2D alone;
layout(set = 0, binding = 6, rgba8) writeonly uniform image2D bytes;
layout(constant_id = 4) const float scale = 0.5;
layout(constant_id = 3) const bool truth = true;
void main() {}
)"}};
    const spirv::reflection r = spirv::reflect(spirv::compile(pieces, spirv::shader_stage::compute));
    REQUIRE(r.bindings.size() == 8);
    CHECK(r.bindings[0].texels == format::rgba8_unorm);
    CHECK(r.bindings[0].writable);
    CHECK(r.bindings[1].name == "alone");
    CHECK(r.bindings[1].kind == binding_kind::other);
    CHECK(r.bindings[2].texels == format::rgba16_float);
    CHECK(!r.bindings[2].writable);
    CHECK(r.bindings[3].arrayed);
    CHECK(r.bindings[3].component == spirv::scalar_kind::unsigned_integer);
    CHECK(r.bindings[4].set == 1);
    CHECK(r.bindings[4].size == 48 + 48 + 16 + 16);
    CHECK(r.bindings[5].name == "nodes");
    CHECK(r.bindings[5].kind == binding_kind::storage_block);
    CHECK(!r.bindings[5].writable);
    CHECK(r.bindings[5].readable);
    CHECK(r.bindings[6].arrayed);
    CHECK(r.bindings[7].multisampled);
    REQUIRE(r.constants.size() == 2);
    CHECK(r.constants[0].type == spirv::scalar_kind::boolean);
    CHECK(r.constants[0].value == 1);
    CHECK(r.constants[1].type == spirv::scalar_kind::floating_point);
    CHECK(r.constants[1].value == 0x3f000000u);
    CHECK(r.workgroup[2].size == 3);
}

TEST_CASE("a buffer is read, written or both, as all of its members are") {
    const piece pieces[] = {
        little::version,
        {"buffers.comp", "layout(std430, set = 0, binding = 0) readonly buffer read { uint a, b; };\n"
                         "layout(std430, set = 0, binding = 1) writeonly buffer written { uint c, d; };\n"
                         "layout(std430, set = 0, binding = 2) buffer both { uint e; };\n"
                         "layout(std430, set = 0, binding = 3) buffer some { readonly uint f; uint g; };\n"
                         "void main() {}\n"}};
    const spirv::reflection r = spirv::reflect(spirv::compile(pieces, spirv::shader_stage::compute));
    REQUIRE(r.bindings.size() == 4);
    const bool readable[] = {true, false, true, true}, writable[] = {false, true, true, true};
    for (std::size_t i = 0; i < 4; ++i) {
        CAPTURE(r.bindings[i].name);
        CHECK(r.bindings[i].readable == readable[i]);
        CHECK(r.bindings[i].writable == writable[i]);
    }
}

TEST_CASE("outputs and attributes are sorted by location, whatever comes first in the text") {
    const piece fragment[] = {little::version,
                              {"two.frag", "layout(location = 1) out vec4 second;\n"
                                           "layout(location = 0) out vec4 first;\n"
                                           "void main() { first = second = vec4(1.0); }\n"}};
    const spirv::reflection drawn = spirv::reflect(spirv::compile(fragment, spirv::shader_stage::fragment));
    REQUIRE(drawn.colours.size() == 2);
    CHECK(drawn.colours[0].name == "first");
    CHECK(drawn.colours[1].name == "second");
    CHECK(drawn.colours[1].location == 1);
    CHECK(drawn.attributes.empty());

    const piece vertex[] = {little::version,
                            {"two.vert",
                             "layout(location = 3) in vec3 later;\n"
                             "layout(location = 1) in vec3 earlier;\n"
                             "layout(location = 0) out vec3 passed;\n"
                             "void main() { passed = later + earlier; gl_Position = vec4(later, 1.0); }\n"}};
    const spirv::reflection fed = spirv::reflect(spirv::compile(vertex, spirv::shader_stage::vertex));
    CHECK(fed.model == spirv::execution_model::vertex);
    CHECK(fed.attributes == std::vector<std::uint32_t>{1, 3});
    CHECK(fed.colours.empty());
}

TEST_CASE("texels of a buffer are another kind of descriptor") {
    const piece pieces[] = {little::version,
                            {"buffers.comp",
                             "layout(set = 0, binding = 0) uniform samplerBuffer read;\n"
                             "layout(set = 0, binding = 1, r32f) uniform imageBuffer stored;\n"
                             "void main() {}\n"}};
    const spirv::reflection r = spirv::reflect(spirv::compile(pieces, spirv::shader_stage::compute));
    REQUIRE(r.bindings.size() == 2);
    CHECK(r.bindings[0].kind == binding_kind::other);
    CHECK(r.bindings[1].kind == binding_kind::other);
}
