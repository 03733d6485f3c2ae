// SPDX-License-Identifier: MIT
// Shaders in other languages, and what the manifest says of them; the texts are tested by tests/translate.
#include "command.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace {

using nlohmann::json;

const std::string drawn = "emit directions:8x4/single_layer/hbao/r32f/fragment --target ";

/// The manifest of what emit made.
json manifest_of(const std::string& command, const temporary_folder& folder) {
    expect_success(command + " -o '" + (folder / "out").string() + "'");
    return json::parse(content_of(folder / "out/crease_shaders.json"));
}

}

TEST_CASE("emit: other languages, with the numbers that their hosts bind by") {
    const struct {
        const char *target, *extension;
        unsigned version;
        const char *block, *image, *entry, *vertex_entry;
        bool has_sampler;
    } languages[] = {
        {"hlsl", ".hlsl", 50, "b_register", "t_register", "main", "main", true},
        {"msl", ".metal", 21, "buffer_index", "texture_index", "visibility_main", "fullscreen_vertex", true},
        {"glsl-es", "", 310, "uniform_block", "texture_unit", "main", "main", false},
        {"glsl", "", 430, "uniform_block", "texture_unit", "main", "main", false}};
    for (const auto& each : languages) {
        CAPTURE(each.target);
        const temporary_folder folder;
        const json manifest = manifest_of(drawn + each.target, folder);
        const std::string main = std::string("0_visibility.frag") + each.extension,
                          vertex = std::string("fullscreen.vert") + each.extension;
        CHECK(files_in(folder / "out") == std::set<std::string>{"crease_shaders.json", main, vertex});
        const json& shaders = manifest["passes"][0]["shaders"];
        REQUIRE(shaders.size() == 2);
        CHECK(shaders[0]["format"] == each.target);
        CHECK(shaders[0]["file"] == main);
        CHECK(shaders[0]["version"] == each.version);
        CHECK(shaders[0]["entry_point"] == each.entry);
        CHECK(shaders[1]["file"] == vertex);
        CHECK(shaders[1]["stage"] == "vertex");
        CHECK(shaders[1]["entry_point"] == each.vertex_entry);
        const std::string text = content_of(folder / ("out/" + main));
        const json& bindings = shaders[0]["bindings"];
        REQUIRE(bindings.size() == 3);
        CHECK(bindings[0]["kind"] == each.block);
        CHECK(bindings[2]["name"] == "normal");
        CHECK(bindings[2]["kind"] == each.image);
        CHECK(bindings[2]["number"] == 1);
        CHECK(bindings[2].contains("sampler") == each.has_sampler);
        for (const json& binding : bindings)
            CHECK(text.find(binding["identifier"]) != text.npos);
        for (const json& constant : shaders[0]["constants"])
            CHECK(text.find(constant.contains("macro")
                                ? constant["macro"].get<std::string>()
                                : "function_constant(" + std::to_string(constant["id"].get<int>()) + ")") !=
                  text.npos);
    }
}

TEST_CASE("emit: a version of a language") {
    const temporary_folder folder;
    CHECK(manifest_of(drawn + "glsl-es --target-version 300", folder)["passes"][0]["shaders"][0]["version"] ==
          300);
    CHECK(content_of(folder / "out/0_visibility.frag").starts_with("#version 300 es\n"));
}

TEST_CASE("emit: of a geometry pass every language has the GLSL") {
    const temporary_folder folder;
    const json manifest = manifest_of("emit directions:8x4/stochastic_layers/hbao --target hlsl", folder);
    CHECK(manifest["passes"][0]["shaders"][0]["format"] == "glsl");
    CHECK(manifest["passes"][1]["shaders"][0]["format"] == "hlsl");
}

TEST_CASE("emit: the number of the array that tells MSL how long buffers are") {
    const temporary_folder folder;
    const json manifest = manifest_of("emit directions:8x4/linear_lists/hbao --target msl", folder);
    const json& of_sort = manifest["passes"][4]["shaders"][0];
    CHECK(of_sort["entry_point"] == "pack_layers_main");
    CHECK(of_sort["buffer_sizes"] == 4);
    CHECK_FALSE(manifest["passes"][5]["shaders"][0].contains("buffer_sizes"));
}

TEST_CASE("emit: what a language cannot is refused, and nothing is written") {
    const struct {
        const char *arguments, *sentence;
    } refused[] = {
        {"--target glsl-es",
         "pass 'visibility' cannot be GLSL ES 3.10: it has crease_output as a storage image of r8_unorm"},
        {"--target hlsl --target-version 40",
         "pass 'visibility' cannot be HLSL 4.0: the versions of HLSL are 50, 51, 60"},
        {"--target-version 50", "--target-version is of a language: say with --target which"},
        {"--target hlsl --format glsl", "--target and --format exclude each other: leave one out"},
        {"--target hlsl --strip",
         "--optimise, --strip and --target-env are of SPIR-V, and none is made here"},
        {"--target hlsl --shape functions", "functions and the dialects opengl and glsl_es come as GLSL"},
        {"--target cg", "cg not in {glsl,glsl-es,hlsl,msl,spirv,wgsl}"}};
    for (const auto& each : refused) {
        CAPTURE(each.arguments);
        const temporary_folder folder;
        const ended done =
            crease_command("emit directions:8x4/single_layer/hbao " + std::string(each.arguments) + " -o '" +
                           (folder / "out").string() + "'");
        CHECK(done.status > 0);
        CAPTURE(done.complained);
        CHECK(done.complained.find(each.sentence) != std::string::npos);
        CHECK(files_in(folder / "").empty());
    }
}
