// SPDX-License-Identifier: MIT
#include <crease/spirv.hpp>

#include "little_effect.hpp"
#include "sentence.hpp"

#include <doctest/doctest.h>

#include <iterator>
#include <string>
#include <string_view>

using namespace crease;
using sentences = std::vector<std::string>;

namespace {

sentences mismatches_of(const pass& declared, const pass& compiled) {
    return spirv::mismatches(little::effect, declared, spirv::reflect(spirv::compile(compiled)));
}

sentences with_binding(std::size_t which, const binding& other) {
    binding bindings[std::size(little::scale_bindings)];
    std::ranges::copy(little::scale_bindings, bindings);
    bindings[which] = other;
    pass declared = little::scale;
    declared.bindings = bindings;
    return mismatches_of(declared, little::scale);
}

/// A pass with a binding of each kind and shape.
namespace every {

constexpr resource resources[] = {
    {.name = "parameters", .kind = resource_kind::block},
    {.name = "tables", .texels = format::rgba32_float, .layers = 2, .arrayed = true},
    {.name = "keys", .texels = format::r32_uint, .read = access::load},
    {.name = "samples", .texels = format::d32_float, .samples = 4},
    {.name = "counts", .texels = format::r32_uint, .layers = 3, .arrayed = true},
    {.name = "visibility", .texels = format::r8_unorm, .life = lifetime::output},
    {.name = "nodes", .kind = resource_kind::buffer, .element = "uvec2", .life = lifetime::transient},
    {.name = "counters", .kind = resource_kind::buffer, .element = "uint", .life = lifetime::report},
};
constexpr binding bindings[] = {
    {"parameters", 0, access::uniform, 0, 0}, {"tables", 1, access::sample, 0, 1},
    {"keys", 2, access::load, 0, 2},          {"samples", 3, access::sample, 0, 3},
    {"counts", 4, access::modify, 0, 4},      {"output", 5, access::store, 1, 5},
    {"nodes", 6, access::load, 0, 7},         {"counters", 7, access::modify, 0, 8},
};
constexpr constant constants[] = {
    {"compute", "width", 0, 8}, {"compute", "height", 1, 4}, {"every", "most", 2, 5}};
constexpr std::string_view text = R"(
layout(local_size_x = 8, local_size_y = 4, local_size_x_id = 0, local_size_y_id = 1) in;
layout(constant_id = 2) const int crease_every_most = 5;
layout(set = 0, binding = 1) uniform sampler2DArray crease_tables;
layout(set = 0, binding = 2, r32ui) readonly uniform uimage2D crease_keys;
layout(set = 0, binding = 3) uniform sampler2DMS crease_samples;
layout(set = 0, binding = 4, r32ui) uniform uimage2DArray crease_counts;
layout(set = 1, binding = 5, r8) writeonly uniform image2D crease_output;
layout(std430, set = 0, binding = 7) readonly buffer crease_nodes_buffer { uvec2 crease_nodes[]; };
layout(std430, set = 0, binding = 8) buffer crease_counters_buffer { uint crease_counters[]; };
void main() {}
)";
constexpr effect_view effect{.passes = {},
                             .resources = resources,
                             .settings = little::settings,
                             .views = 2,
                             .features = {},
                             .defaults = {}};
constexpr pass declared{.name = "every",
                        .pieces = {},
                        .vertex_pieces = {},
                        .bindings = bindings,
                        .constants = constants,
                        .size = {}};

/// What differs where the GLSL has `to` in the place of `from`.
sentences with(std::string_view from, std::string_view to, const pass& declared_as = declared) {
    std::string whole = std::string(little::block_text).append(text);
    const std::size_t at = whole.find(from);
    REQUIRE(at != std::string::npos);
    whole.replace(at, from.size(), to);
    const piece pieces[] = {little::version, {"every.glsl", whole}};
    return spirv::mismatches(effect, declared_as,
                             spirv::reflect(spirv::compile(pieces, spirv::shader_stage::compute)));
}

}

}

TEST_CASE("what is declared as it is compiled has no mismatch") {
    CHECK(mismatches_of(little::scale, little::scale).empty());
    CHECK(mismatches_of(little::spread, little::spread).empty());
}

TEST_CASE("a binding in another place") {
    CHECK(
        with_binding(1, {"depth", 1, access::sample, 0, 5}) ==
        sentences{"pass 'scale': the SPIR-V has nothing at set 0 binding 5, where crease_depth is declared",
                  "pass 'scale': the SPIR-V has crease_depth at set 0 binding 1, where nothing is declared"});
}

TEST_CASE("a binding of another name, kind or format") {
    CHECK(
        with_binding(1, {"normals", 1, access::sample, 0, 1}) ==
        sentences{
            "pass 'scale': set 0 binding 1 is declared as crease_normals, but the SPIR-V has crease_depth"});
    CHECK(
        with_binding(1, {"depth", 1, access::store, 0, 1}) ==
        sentences{
            "pass 'scale': crease_depth is declared as a storage image, but the SPIR-V has a sampled image"});
    CHECK(with_binding(2, {"output", 3, access::store, 0, 2}) ==
          sentences{"pass 'scale': the format of crease_output is declared as r8_unorm, but the SPIR-V has "
                    "r32_float"});
}

TEST_CASE("another specialization constant or workgroup size") {
    const constant constants[] = {
        {"compute", "width", 0, 16}, {"compute", "height", 1, 4}, {"scale", "gain", 3, 2}};
    pass declared = little::scale;
    declared.constants = constants;
    CHECK(mismatches_of(declared, little::scale) ==
          sentences{
              "pass 'scale': the default of crease_compute_width is declared as 16, but the SPIR-V has 8",
              "pass 'scale': the SPIR-V has no constant_id 3, which is declared as crease_scale_gain",
              "pass 'scale': the SPIR-V has constant_id 2 (crease_scale_gain), which is not declared",
              "pass 'scale': the workgroup's x is declared as 16, but the SPIR-V has 8",
          });
}

TEST_CASE("another stage") {
    const sentences found = mismatches_of(little::spread, little::scale);
    REQUIRE(found.size() > 1);
    CHECK(found[0] == "pass 'spread': the SPIR-V is not a fragment shader");
    CHECK(found[1] ==
          "pass 'spread': its attachments want colour outputs of location 0, but the SPIR-V has no location");
}

TEST_CASE("a fragment shader's outputs in other places") {
    spirv::reflection found = spirv::reflect(spirv::compile(little::spread));
    found.colours = {{.location = 1, .name = {}}, {.location = 2, .name = {}}};
    CHECK(spirv::mismatches(little::effect, little::spread, found) ==
          sentences{"pass 'spread': its attachments want colour outputs of location 0, but the SPIR-V has "
                    "locations 1, 2"});
    found.colours = {{.location = 1, .name = {}}};
    CHECK(spirv::mismatches(little::effect, little::spread, found) ==
          sentences{"pass 'spread': its attachments want colour outputs of location 0, but the SPIR-V has "
                    "location 1"});
    found.colours = {};
    CHECK(spirv::mismatches(little::effect, little::spread, found) ==
          sentences{"pass 'spread': its attachments want colour outputs of location 0, but the SPIR-V has no "
                    "location"});
}

TEST_CASE("another entry point") {
    spirv::reflection found = spirv::reflect(spirv::compile(little::scale));
    found.entry_point = "run";
    CHECK(spirv::mismatches(little::effect, little::scale, found) ==
          sentences{"pass 'scale': the entry point is 'run', not 'main'"});
}

TEST_CASE("a binding of each kind and shape is as it is declared") {
    CHECK(every::with("void main() {}", "void main() {}").empty());
}

TEST_CASE("a binding in another set") {
    CHECK(every::with("set = 1, binding = 5", "set = 0, binding = 5") ==
          sentences{
              "pass 'every': the SPIR-V has nothing at set 1 binding 5, where crease_output is declared",
              "pass 'every': the SPIR-V has crease_output at set 0 binding 5, where nothing is declared"});
}

TEST_CASE("a binding that is missing, and one too many") {
    CHECK(every::with("layout(set = 0, binding = 3) uniform sampler2DMS crease_samples;", "") ==
          sentences{
              "pass 'every': the SPIR-V has nothing at set 0 binding 3, where crease_samples is declared"});
    CHECK(every::with("void main()", "layout(set = 0, binding = 6) uniform sampler2D own; void main()") ==
          sentences{"pass 'every': the SPIR-V has own at set 0 binding 6, where nothing is declared"});
}

TEST_CASE("each kind of descriptor in the place of another") {
    CHECK(every::with("sampler2DArray", "texture2DArray") ==
          sentences{"pass 'every': crease_tables is declared as a sampled image, but the SPIR-V has another "
                    "kind of descriptor"});
    CHECK(
        every::with("binding = 2, r32ui) readonly uniform uimage2D", "binding = 2) uniform usampler2D") ==
        sentences{
            "pass 'every': crease_keys is declared as a storage image, but the SPIR-V has a sampled image"});
    CHECK(every::with("layout(std140, set = 0, binding = 0) uniform",
                      "layout(std430, set = 0, binding = 0) buffer") ==
          sentences{
              "pass 'every': crease_parameters is declared as a uniform block, but the SPIR-V has a storage "
              "block"});
    CHECK(
        every::with("binding = 3) uniform sampler2DMS crease_samples",
                    "binding = 3) uniform crease_samples { vec4 v; }") ==
        sentences{"pass 'every': crease_samples is declared as a sampled image, but the SPIR-V has a uniform "
                  "block"});
}

TEST_CASE("another format of each storage image") {
    CHECK(every::with("binding = 2, r32ui", "binding = 2, rg32ui") ==
          sentences{"pass 'every': the format of crease_keys is declared as r32_uint, but the SPIR-V has "
                    "rg32_uint"});
    CHECK(every::with("binding = 4, r32ui", "binding = 4, rgba8ui") ==
          sentences{
              "pass 'every': the format of crease_counts is declared as r32_uint, but the SPIR-V has none"});
    CHECK(every::with("r8)", "rgba8)") ==
          sentences{"pass 'every': the format of crease_output is declared as r8_unorm, but the SPIR-V has "
                    "rgba8_unorm"});
}

TEST_CASE("another type of texels") {
    CHECK(every::with("sampler2DArray", "usampler2DArray") ==
          sentences{
              "pass 'every': crease_tables holds rgba32_float, which the SPIR-V accesses as another type"});
    CHECK(every::with("r32ui) readonly uniform uimage2D", "r32f) readonly uniform image2D") ==
          sentences{
              "pass 'every': the format of crease_keys is declared as r32_uint, but the SPIR-V has r32_float",
              "pass 'every': crease_keys holds r32_uint, which the SPIR-V accesses as another type"});
    CHECK(
        every::with("r32ui) readonly uniform uimage2D", "r32i) readonly uniform iimage2D") ==
        sentences{"pass 'every': the format of crease_keys is declared as r32_uint, but the SPIR-V has none",
                  "pass 'every': crease_keys holds r32_uint, which the SPIR-V accesses as another type"});
}

TEST_CASE("an array where there is none, and none where there is one") {
    CHECK(every::with("sampler2DArray", "sampler2D") ==
          sentences{"pass 'every': crease_tables is declared as an array, but in the SPIR-V it is none"});
    CHECK(every::with("uimage2D crease_keys", "uimage2DArray crease_keys") ==
          sentences{"pass 'every': crease_keys is declared as no array, but in the SPIR-V it is one"});
}

TEST_CASE("one sample where there are several, and several where there is one") {
    CHECK(every::with("sampler2DMS", "sampler2D") ==
          sentences{"pass 'every': crease_samples is declared with 4 samples, but in the SPIR-V it is not "
                    "multisampled"});
    CHECK(every::with("sampler2DArray", "sampler2DMSArray") ==
          sentences{
              "pass 'every': crease_tables is declared with 1 sample, but in the SPIR-V it is multisampled"});
}

TEST_CASE("another access to a storage image") {
    CHECK(every::with("writeonly", "readonly") ==
          sentences{"pass 'every': crease_output is declared as stored to, but the SPIR-V only reads it"});
    CHECK(every::with("writeonly", "") ==
          sentences{"pass 'every': crease_output is declared as stored to, but the SPIR-V may also read it"});
    CHECK(every::with("readonly", "") ==
          sentences{"pass 'every': crease_keys is declared as loaded, but the SPIR-V may store to it"});
    CHECK(every::with("r32ui) uniform", "r32ui) readonly uniform") ==
          sentences{"pass 'every': crease_counts is declared as stored to, but the SPIR-V only reads it"});
    CHECK(every::with("r32ui) uniform", "r32ui) writeonly uniform") ==
          sentences{"pass 'every': crease_counts is declared as changed, but the SPIR-V only stores to it"});
}

TEST_CASE("a constant of another id, name or default") {
    CHECK(every::with("constant_id = 2", "constant_id = 3") ==
          sentences{"pass 'every': the SPIR-V has no constant_id 2, which is declared as crease_every_most",
                    "pass 'every': the SPIR-V has constant_id 3 (crease_every_most), which is not declared"});
    CHECK(every::with("crease_every_most", "crease_every_least") ==
          sentences{"pass 'every': constant_id 2 is declared as crease_every_most, but the SPIR-V has "
                    "crease_every_least"});
    CHECK(
        every::with("most = 5", "most = -5") ==
        sentences{"pass 'every': the default of crease_every_most is declared as 5, but the SPIR-V has -5"});
}

TEST_CASE("a workgroup of another size, or set by another constant") {
    CHECK(
        every::with("local_size_y = 4", "local_size_y = 2") ==
        sentences{"pass 'every': the default of crease_compute_height is declared as 4, but the SPIR-V has 2",
                  "pass 'every': the workgroup's y is declared as 4, but the SPIR-V has 2"});
    CHECK(every::with("local_size_y = 4,", "local_size_y = 4, local_size_z = 3,") ==
          sentences{"pass 'every': the workgroup's z is declared as 1, but the SPIR-V has 3"});
    CHECK(
        every::with("local_size_y_id = 1", "local_size_y_id = 6") ==
        sentences{"pass 'every': the SPIR-V has no constant_id 1, which is declared as crease_compute_height",
                  "pass 'every': the SPIR-V has constant_id 6, which is not declared",
                  "pass 'every': the workgroup's y is not set by constant_id 1"});
    CHECK(
        every::with("local_size_x_id = 0, local_size_y_id = 1", "local_size_x_id = 1, local_size_y_id = 0") ==
        sentences{"pass 'every': the default of crease_compute_width is declared as 8, but the SPIR-V has 4",
                  "pass 'every': the default of crease_compute_height is declared as 4, but the SPIR-V has 8",
                  "pass 'every': the workgroup's x is not set by constant_id 0",
                  "pass 'every': the workgroup's y is not set by constant_id 1"});
}

TEST_CASE("a compute pass without the constants of its workgroup") {
    pass declared = every::declared;
    declared.constants = {};
    const sentences found = every::with("void main() {}", "void main() {}", declared);
    REQUIRE(!found.empty());
    CHECK(
        found.back() ==
        "pass 'every': a compute pass declares its workgroup's width and height as its first two constants");
}

TEST_CASE("a block that is not that of the effect's settings") {
    CHECK(every::with("float spread_bias;\n    float spread_slope;",
                      "float spread_slope;\n    float spread_bias;") ==
          sentences{"pass 'every': the offset of spread_bias is declared as 168, but the SPIR-V has 172",
                    "pass 'every': the offset of spread_slope is declared as 172, but the SPIR-V has 168"});
    CHECK(every::with("float strength;", "float scale_strength;") ==
          sentences{"pass 'every': the block of parameters in the SPIR-V lacks strength",
                    "pass 'every': the effect's parameters lack scale_strength, which is in the SPIR-V"});
    CHECK(
        every::with("float strength;", "float strength[2];") ==
        sentences{"pass 'every': the size of the block of parameters is declared as 192, but the SPIR-V has "
                  "208"});
    CHECK(
        every::with("uint frame;", "uint frame[2];") ==
        sentences{"pass 'every': the offset of frame is declared as 164, but the SPIR-V has 176",
                  "pass 'every': the offset of spread_bias is declared as 168, but the SPIR-V has 208",
                  "pass 'every': the offset of spread_slope is declared as 172, but the SPIR-V has 212",
                  "pass 'every': the offset of strength is declared as 176, but the SPIR-V has 216",
                  "pass 'every': the size of the block of parameters is declared as 192, but the SPIR-V has "
                  "224"});
}

TEST_CASE("a block of other cameras than the effect has") {
    const sentences found = every::with("views[2];\n    mat4 from_first[1];", "views[1];");
    REQUIRE(found.size() > 2);
    CHECK(found[0] == "pass 'every': the block of parameters in the SPIR-V lacks from_first");
    CHECK(found[1] == "pass 'every': the offset of radius is declared as 160, but the SPIR-V has 48");
    effect_view one = every::effect;
    one.views = 1;
    const piece pieces[] = {little::version, {"every.glsl", every::text}};
    const piece block_of_two[] = {little::version, little::block, {"every.glsl", every::text}};
    const auto reflected = [](std::span<const piece> text) {
        return spirv::reflect(spirv::compile(text, spirv::shader_stage::compute));
    };
    CHECK(
        spirv::mismatches(one, every::declared, reflected(pieces)) ==
        sentences{
            "pass 'every': the SPIR-V has nothing at set 0 binding 0, where crease_parameters is declared"});
    const sentences two = spirv::mismatches(one, every::declared, reflected(block_of_two));
    REQUIRE(!two.empty());
    CHECK(two[0] == "pass 'every': the offset of radius is declared as 48, but the SPIR-V has 160");
    CHECK(std::ranges::find(
              two, "pass 'every': the effect's parameters lack from_first, which is in the SPIR-V") !=
          two.end());
}

TEST_CASE("another access to a storage buffer, another kind in its place, or another name") {
    CHECK(every::with("readonly buffer", "buffer") ==
          sentences{"pass 'every': crease_nodes is declared as loaded, but the SPIR-V may store to it"});
    CHECK(every::with(") buffer crease_counters", ") readonly buffer crease_counters") ==
          sentences{"pass 'every': crease_counters is declared as stored to, but the SPIR-V only reads it"});
    CHECK(every::with("crease_nodes_buffer", "crease_nodes_of_a_list") ==
          sentences{"pass 'every': set 0 binding 7 is declared as crease_nodes_buffer, but the SPIR-V has "
                    "crease_nodes_of_a_list"});
    CHECK(every::with("layout(std430, set = 0, binding = 8) buffer crease_counters_buffer { uint "
                      "crease_counters[]; };",
                      "layout(set = 0, binding = 8, r32ui) uniform uimage2D crease_counters_buffer;") ==
          sentences{
              "pass 'every': crease_counters is declared as a storage block, but the SPIR-V has a storage "
              "image"});
    CHECK(every::with("layout(std430, set = 0, binding = 8) buffer crease_counters_buffer { uint "
                      "crease_counters[]; };",
                      "") == sentences{"pass 'every': the SPIR-V has nothing at set 0 binding 8, where "
                                       "crease_counters is declared"});
}

TEST_CASE("a geometry pass is compared by its bindings and constants, whatever the host's stage") {
    pass declared{.name = "layers",
                  .stage = stage_kind::geometry,
                  .pieces = {},
                  .vertex_pieces = {},
                  .bindings = little::scale_bindings,
                  .constants = little::scale_constants,
                  .size = {}};
    const spirv::reflection found = spirv::reflect(spirv::compile(little::scale));
    CHECK(spirv::mismatches(little::effect, declared, found).empty());
    declared.bindings = array_view<const binding>(little::scale_bindings, 2);
    declared.constants = array_view<const constant>(little::scale_constants, 2);
    CHECK(
        spirv::mismatches(little::effect, declared, found) ==
        sentences{"pass 'layers': the SPIR-V has crease_output at set 0 binding 2, where nothing is declared",
                  "pass 'layers': the SPIR-V has constant_id 2 (crease_scale_gain), which is not declared"});
}
