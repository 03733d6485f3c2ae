// SPDX-License-Identifier: MIT
#include "scene/gltf_material.hpp"

#include "expect_error.hpp"

#include <nlohmann/json.hpp>

using namespace crease::tools;

namespace {

std::optional<material> read(const std::string& text) {
    const nlohmann::json json = nlohmann::json::parse(text);
    return read_gltf_material(gltf_value(json, "materials[0]"));
}

/// A material of a base colour whose alpha is .4.
std::optional<material> read_with(const std::string& more) {
    return read(R"({"pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 0.4]}, )" + more + "}");
}

void check_refused(const std::string& text, const std::string& part) {
    expect_error<scene_error>(part, [&] { read(text); });
}

}

TEST_CASE("glTF material: white and opaque, unless the file says otherwise") {
    CHECK(read("{}") == material{});
    CHECK(read(R"({"pbrMetallicRoughness": {}, "doubleSided": true, "name": "a"})") == material{});
    CHECK(read(R"({"alphaMode": "BLEND"})") == material{});
}

TEST_CASE("glTF material: the alpha is the opacity of what blends") {
    CHECK(read_with(R"("alphaMode": "BLEND")") == material{{0.1f, 0.2f, 0.3f, 0.4f}});
    CHECK(read_with(R"("alphaMode": "OPAQUE")") == material{{0.1f, 0.2f, 0.3f, 1}});
    CHECK(read_with(R"("doubleSided": false)") == material{{0.1f, 0.2f, 0.3f, 1}});
}

TEST_CASE("glTF material: a mask is there or not") {
    const std::optional<material> there = material{{0.1f, 0.2f, 0.3f, 1}};
    CHECK(read_with(R"("alphaMode": "MASK")") == std::nullopt); // below .5
    CHECK(read_with(R"("alphaMode": "MASK", "alphaCutoff": 0.41)") == std::nullopt);
    CHECK(read_with(R"("alphaMode": "MASK", "alphaCutoff": 0.39)") == there);
    CHECK(read_with(R"("alphaMode": "MASK", "alphaCutoff": 0)") == there);
    CHECK(read(R"({"alphaMode": "MASK"})") == material{});
    CHECK(read(R"({"alphaMode": "MASK", "alphaCutoff": 1.5})") == std::nullopt);
}

TEST_CASE("glTF material: what is no colour, mode or cutoff") {
    for (const std::string factor : {"[1, 1, 1]", "[1, 1, 1, 1, 1]"})
        check_refused(R"({"pbrMetallicRoughness": {"baseColorFactor": )" + factor + "}}",
                      "materials[0].pbrMetallicRoughness.baseColorFactor must be a list of 4 numbers");
    for (const std::string factor : {"[1, 1, 1, 1.5]", "[1, 1, 1, -0.1]", "[2, 1, 1, 1]"})
        check_refused(R"({"pbrMetallicRoughness": {"baseColorFactor": )" + factor + "}}",
                      "materials[0].pbrMetallicRoughness.baseColorFactor must be four numbers from 0 to 1");
    check_refused(R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, null]}})",
                  "baseColorFactor[3] must be a number");
    check_refused(R"({"alphaMode": "GLASS"})",
                  "materials[0].alphaMode is 'GLASS', and must be OPAQUE, MASK or BLEND; export it again");
    check_refused(R"({"alphaMode": 1})", "materials[0].alphaMode must be a text");
    check_refused(R"({"alphaMode": "MASK", "alphaCutoff": -1})",
                  "materials[0].alphaCutoff must not be negative");
    check_refused(R"({"alphaMode": "MASK", "alphaCutoff": "a"})",
                  "materials[0].alphaCutoff must be a number");
    check_refused(R"({"doubleSided": 1})", "materials[0].doubleSided must be true or false");
}
