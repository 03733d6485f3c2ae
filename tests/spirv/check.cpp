// SPDX-License-Identifier: MIT
#include <crease/spirv.hpp>

#include "little_effect.hpp"

#include <doctest/doctest.h>

#include <iterator>

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

TEST_CASE("a block that is not crease::parameters") {
    const piece other{"block.glsl", "layout(std140, set = 0, binding = 0) uniform crease_parameters {\n"
                                    "    float crease_radius, crease_bias, crease_new; };\n"};
    const piece pieces[] = {little::version, other, little::scale_interface, little::scale_body};
    pass compiled = little::scale;
    compiled.pieces = pieces;
    const sentences found = mismatches_of(little::scale, compiled);
    const auto has = [&found](std::string_view sentence) {
        return std::ranges::find(found, sentence) != found.end();
    };
    CHECK(has("pass 'scale': the offset of crease_radius is declared as 160, but the SPIR-V has 0"));
    CHECK(has("pass 'scale': the block of parameters in the SPIR-V lacks crease_frame"));
    CHECK(has("pass 'scale': crease::parameters lacks crease_new, which is in the SPIR-V"));
    CHECK(has("pass 'scale': the size of the block of parameters is declared as 208, but the SPIR-V has 16"));
}
