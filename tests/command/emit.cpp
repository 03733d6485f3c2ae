// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <crease/compose/composition.hpp>

#include <doctest/doctest.h>

#include <cstring>
#include <memory>
#include <sstream>

namespace {

constexpr const char* text = "directions:8x4/single_layer/hbao/bilateral";

const std::set<std::string> stems{"0_visibility.comp", "1_bilateral_x.comp", "2_bilateral_y.comp"};

/// The stems with an extension, as files are named, and the manifest.
std::set<std::string> with(const std::string& extension) {
    std::set<std::string> names{"crease_shaders.json"};
    for (const std::string& stem : stems)
        names.insert(stem + extension);
    return names;
}

/// What emit wrote, after it said so line by line.
std::set<std::string> emitted(const std::string& arguments, const temporary_folder& folder) {
    const std::string said = expect_success("emit " + arguments + " -o '" + (folder / "out").string() + "'");
    const std::set<std::string> files = files_in(folder / "out");
    std::set<std::string> listed;
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);)
        listed.insert(std::filesystem::path(line).filename().string());
    CHECK(listed == files);
    return files;
}

/// Expects that emit refuses with a sentence, and leaves a folder as it is.
void expect_refused(const std::string& sentence, const std::string& arguments,
                    const temporary_folder& folder) {
    CAPTURE(arguments);
    const std::set<std::string> before = files_in(folder / "");
    const ended done = crease_command("emit " + arguments + " -o '" + (folder / "out").string() + "'");
    CHECK(done.status > 0);
    CHECK(done.complained.find(sentence) != std::string::npos);
    CHECK(files_in(folder / "") == before);
}

std::string pieces_of(const crease::pass& p) {
    std::string whole;
    for (const crease::piece& each : p.pieces)
        whole += each.text;
    return whole;
}

}

TEST_CASE("emit: GLSL is that of the composition") {
    const temporary_folder folder;
    CHECK(emitted(text, folder) == with(""));
    const auto composed = std::make_unique<crease::composition>(crease::recipe(std::string_view(text)));
    std::size_t i = 0;
    for (const std::string& name : stems) // in the order of the passes
        CHECK(content_of(folder / ("out/" + name)) == pieces_of(composed->view().passes[i++]));
}

TEST_CASE("emit: SPIR-V begins with its magic number") {
    const temporary_folder folder;
    CHECK(emitted(std::string(text) + " --format spirv", folder) == with(".spv"));
    for (const std::string& stem : stems) {
        const std::string name = stem + ".spv";
        const std::string bytes = content_of(folder / ("out/" + name));
        REQUIRE(bytes.size() > 100);
        CHECK(bytes.size() % 4 == 0);
        std::uint32_t magic = 0;
        std::memcpy(&magic, bytes.data(), 4);
        CHECK(magic == 0x07230203);
    }
    const temporary_folder other;
    CHECK(emitted(std::string(text) + " --format spirv-asm", other) == with(".spvasm"));
    for (const std::string& stem : stems) {
        const std::string assembly = content_of(other / ("out/" + stem + ".spvasm"));
        CHECK(assembly.starts_with("OpCapability Shader\n"));
        CHECK(assembly.find("OpEntryPoint GLCompute %main \"main\"") != std::string::npos);
    }
}

TEST_CASE("emit: a header has an array of each pass, of the words of its SPIR-V") {
    const temporary_folder folder;
    CHECK(emitted(std::string(text) + " --format header --name shaders", folder) ==
          std::set<std::string>{"shaders.hpp", "shaders.json"});
    const std::string header = content_of(folder / "out/shaders.hpp");
    CHECK(header.find("namespace shaders {") != std::string::npos);
    for (const char* name : {"visibility", "bilateral_x", "bilateral_y"}) {
        CAPTURE(name);
        const std::string begin = "constexpr std::uint32_t " + std::string(name) + "[] = {\n    0x07230203, ";
        CHECK(header.find(begin) != std::string::npos);
    }
}

TEST_CASE("emit: functions for OpenGL have no main and no version") {
    const temporary_folder folder;
    CHECK(emitted(std::string(text) + " --shape functions --dialect opengl", folder) ==
          std::set<std::string>{"0_visibility.glsl", "1_bilateral_x.glsl", "2_bilateral_y.glsl",
                                "crease_shaders.json"});
    for (const char* name : {"0_visibility.glsl", "1_bilateral_x.glsl", "2_bilateral_y.glsl"}) {
        const std::string glsl = content_of(folder / (std::string("out/") + name));
        CHECK(glsl.find("void main()") == std::string::npos);
        CHECK(glsl.find("#version") == std::string::npos);
    }
    CHECK(content_of(folder / "out/2_bilateral_y.glsl").find("float crease_visibility(ivec2 pixel)") !=
          std::string::npos);
}

TEST_CASE("emit: a geometry pass is functions for the host's shader in every format, the others programs") {
    const std::string layered = "directions:4x4/stochastic_layers:8/hbao/atomic_minimum";
    const auto composed = std::make_unique<crease::composition>(crease::recipe(std::string_view(layered)));
    const std::string captures = pieces_of(composed->view().passes[0]);
    CHECK(captures.find("void crease_capture(vec3 anchor)") != std::string::npos);
    CHECK(captures.find("#version") == std::string::npos);
    for (const char* format : {"glsl", "spirv", "spirv-asm"}) {
        CAPTURE(format);
        const temporary_folder folder;
        const std::set<std::string> files = emitted(layered + " --format " + format, folder);
        REQUIRE(files.contains("0_capture_layers.glsl"));
        CHECK(content_of(folder / "out/0_capture_layers.glsl") == captures);
        CHECK(files.contains("subsets.r32_uint.bin")); // the texels of a constant
        CHECK(files.size() == composed->view().passes.size() + 2);
        std::size_t geometry = 0;
        for (const std::string& file : files)
            geometry += file.ends_with(".glsl");
        CHECK(geometry == 1);
    }
    const temporary_folder folder;
    CHECK(emitted(layered + " --format header --name shaders", folder) ==
          std::set<std::string>{"shaders.hpp", "shaders.json"});
    const std::string header = content_of(folder / "out/shaders.hpp");
    CHECK(header.find("constexpr char capture_layers[] =\n    \"// ") != std::string::npos);
    CHECK(header.find("constexpr std::uint32_t visibility[] = {\n    0x07230203, ") != std::string::npos);
}

TEST_CASE("emit: the manifest says what belongs, and what a host must know of it") {
    const temporary_folder folder;
    std::set<std::string> files = emitted(std::string(text) + "/fragment --format spirv", folder);
    const nlohmann::json told = json_in(folder / "out/crease_shaders.json");
    files.erase("crease_shaders.json");
    CHECK(told.at("files").get<std::set<std::string>>() == files);
    CHECK(told.at("recipe") == "directions:8x4x2/single_layer/hbao/bilateral:3/fragment");
    const auto composed = std::make_unique<crease::composition>(
        crease::recipe(std::string_view(std::string(text) + "/fragment")));
    const crease::effect_view effect = composed->view();
    REQUIRE(told.at("passes").size() == effect.passes.size());
    for (std::size_t i = 0; i < effect.passes.size(); ++i) {
        const nlohmann::json& pass = told["passes"][i];
        CHECK(pass.at("name") == std::string(effect.passes[i].name));
        CHECK(pass.at("stage") == "fragment");
        REQUIRE(pass.at("bindings").size() == effect.passes[i].bindings.size());
        for (std::size_t b = 0; b < effect.passes[i].bindings.size(); ++b) {
            const crease::binding& declared = effect.passes[i].bindings[b];
            CHECK(pass["bindings"][b].at("name") == std::string(declared.name));
            CHECK(pass["bindings"][b].at("slot") == declared.slot);
            CHECK(pass["bindings"][b].at("resource") ==
                  std::string(effect.resources[declared.resource].name));
        }
        const nlohmann::json& shaders = pass.at("shaders");
        REQUIRE(shaders.size() == 2);
        CHECK(shaders[0].at("stage") == "fragment");
        CHECK(shaders[0].at("environment") == "vulkan1.1");
        CHECK(shaders[1].at("file") == "fullscreen.vert.spv");
    }
    CHECK(told["passes"][0]["constants"][0] ==
          nlohmann::json{{"id", 0}, {"part", "directions"}, {"number", "count"}, {"value", 8}});
    CHECK(told.at("resources").size() == effect.resources.size());
    CHECK(told["resources"].back().at("lifetime") == "output");
    CHECK(told["resources"].back().at("format") == "r8_unorm");
    const nlohmann::json& block = told.at("uniform_block");
    CHECK(block.at("size") == effect.block_size());
    CHECK(block.at("members")[6] == nlohmann::json{{"name", "radius"}, {"type", "float"}, {"offset", 48}});
    CHECK(block.at("members").back().at("name") == "bilateral.sharpness");
    CHECK(block.at("members").back().at("offset") == 72);
    CHECK(block.at("members").back().at("default") == 32);
    CHECK(told.at("features").at("depth_samples") == 0);
}

TEST_CASE("emit: what an earlier recipe left and no longer belongs goes, and nothing else") {
    const temporary_folder folder;
    CHECK(emitted(std::string(text) + " --format spirv", folder) == with(".spv"));
    folder.put("out/mine.txt", "of the host");
    expect_success("emit directions:4x4/single_layer/hbao --format glsl -o '" + (folder / "out").string() +
                   "'");
    CHECK(files_in(folder / "out") ==
          std::set<std::string>{"0_visibility.comp", "crease_shaders.json", "mine.txt"});
    // Another name is another emission.
    expect_success("emit directions:8x4/single_layer/hbao_plus --format header --name other -o '" +
                   (folder / "out").string() + "'");
    expect_success("emit directions:4x4/single_layer/hbao_plus --format header --name third -o '" +
                   (folder / "out").string() + "'");
    CHECK(files_in(folder / "out") == std::set<std::string>{"0_visibility.comp", "crease_shaders.json",
                                                            "mine.txt", "other.hpp", "other.json",
                                                            "third.hpp", "third.json"});
}

TEST_CASE("emit: GLSL and SPIR-V of one recipe come together") {
    const temporary_folder folder;
    std::set<std::string> both = with("");
    both.merge(with(".spv"));
    CHECK(emitted(std::string(text) + " --format glsl,spirv", folder) == both);
}

TEST_CASE("emit: a file of another's where the manifest goes is left alone") {
    for (const char* foreign :
         {"{\"name\": \"mine\"}", "no JSON", "{\"manifest\": 1, \"crease\": \"0\", \"files\": [\"../kept\"]}",
          "{\"manifest\": 1, \"crease\": \"0\", \"files\": [7]}"}) {
        CAPTURE(foreign);
        const temporary_folder folder;
        std::filesystem::create_directory(folder / "out");
        folder.put("kept", "");
        folder.put("out/crease_shaders.json", foreign);
        expect_refused("is none of crease's", text, folder);
        CHECK(content_of(folder / "out/crease_shaders.json") == foreign);
    }
}

TEST_CASE("emit: where it is refused, what an earlier recipe left stays whole") {
    const temporary_folder folder;
    emitted(text, folder);
    expect_refused("no part of the name 'nothing'", "nothing/single_layer/hbao", folder);
    std::filesystem::remove(folder / "out/1_bilateral_x.comp");
    std::filesystem::create_directory(folder / "out/1_bilateral_x.comp"); // cannot be replaced
    expect_refused("not a regular file", std::string(text) + " --stage compute", folder);
    CHECK(files_in(folder / "out").contains("2_bilateral_y.comp"));
}

TEST_CASE("emit: stage, dialect and shape are obeyed, or refused where the recipe says another") {
    const temporary_folder folder;
    const std::string hbao = "directions:4x4/single_layer/hbao";
    CHECK(emitted(hbao + " --stage fragment", folder) ==
          std::set<std::string>{"0_visibility.frag", "crease_shaders.json", "fullscreen.vert"});
    CHECK(emitted(hbao + "/fragment --stage fragment", folder).contains("0_visibility.frag"));
    CHECK(emitted(hbao + "/fragment", folder).contains("0_visibility.frag"));
    const temporary_folder other;
    expect_refused("the recipe says 'fragment' and the option --stage 'compute'",
                   hbao + "/fragment --stage compute", other);
    expect_refused("the recipe says 'opengl' and the option --dialect 'vulkan'",
                   hbao + "/opengl --dialect vulkan", other);
    expect_refused("the recipe says 'functions' and the option --shape 'program'",
                   hbao + "/functions --shape program", other);
    expect_refused("--stage and --shape functions exclude each other",
                   hbao + " --shape functions --stage compute", other);
}

TEST_CASE(
    "emit: SPIR-V is optimised, stripped and for a version, and these are refused where there is none") {
    const std::string hbao = "directions:4x4/single_layer/hbao";
    const auto size_with = [&hbao](const std::string& options) {
        const temporary_folder folder;
        emitted(hbao + " --format spirv " + options, folder);
        const std::string bytes = content_of(folder / "out/0_visibility.comp.spv");
        std::uint32_t version = 0;
        std::memcpy(&version, bytes.data() + 4, 4);
        CHECK(version == (options.find("vulkan1.3") == std::string::npos ? 0x00010300 : 0x00010600));
        return bytes.size();
    };
    const std::size_t plain = size_with("");
    CHECK(size_with("--strip") < plain * 8 / 10);
    CHECK(size_with("--strip --optimise size") < plain * 6 / 10);
    CHECK(size_with("--optimise speed") < plain);
    size_with("--target-env vulkan1.3");
    const temporary_folder folder;
    for (const char* option : {"--strip", "--optimise size", "--target-env vulkan1.1"}) {
        expect_refused("are of SPIR-V, and none is made here", hbao + " " + option, folder);
        expect_refused("are of SPIR-V, and none is made here",
                       hbao + " --format header --dialect opengl " + option, folder);
    }
    expect_refused("--optimise: fast not in {size,speed}", hbao + " --optimise fast", folder);
    expect_refused("--format: hlsl not in {glsl,header,spirv,spirv-asm}", hbao + " --format glsl,hlsl",
                   folder);
    expect_refused("--target-env: vulkan2 not in", hbao + " --format spirv --target-env vulkan2", folder);
}

TEST_CASE("emit: names that are no namespace are refused in every format") {
    const temporary_folder folder;
    for (const char* name :
         {"class", "1x", "a-b", "''", "std", "crease", "linux", "_a", "a__b", "co_await", "../a"})
        for (const char* format : {"glsl", "header"})
            expect_refused("the name '", std::string(text) + " --format " + format + " --name " + name,
                           folder);
    CHECK(emitted(std::string(text) + " --format header --name classy", folder).contains("classy.hpp"));
}
