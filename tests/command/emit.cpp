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

/// The stems with an extension, as files are named.
std::set<std::string> with(const std::string& extension) {
    std::set<std::string> names;
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
    for (const std::string& name : stems)
        CHECK(content_of(folder / ("out/" + name)) == pieces_of(composed->view().passes[i++]));
}

TEST_CASE("emit: SPIR-V begins with its magic number") {
    const temporary_folder folder;
    CHECK(emitted(std::string(text) + " --format spirv", folder) == with(".spv"));
    for (const std::string& name : with(".spv")) {
        const std::string bytes = content_of(folder / ("out/" + name));
        REQUIRE(bytes.size() > 100);
        CHECK(bytes.size() % 4 == 0);
        std::uint32_t magic = 0;
        std::memcpy(&magic, bytes.data(), 4);
        CHECK(magic == 0x07230203);
    }
    const temporary_folder other;
    CHECK(emitted(std::string(text) + " --format spirv-asm", other) == with(".spvasm"));
    for (const std::string& name : with(".spvasm")) {
        const std::string assembly = content_of(other / ("out/" + name));
        CHECK(assembly.starts_with("OpCapability Shader\n"));
        CHECK(assembly.find("OpEntryPoint GLCompute %main \"main\"") != std::string::npos);
    }
}

TEST_CASE("emit: a header has an array of each pass, of the words of its SPIR-V") {
    const temporary_folder folder;
    CHECK(emitted(std::string(text) + " --format header --name shaders", folder) ==
          std::set<std::string>{"shaders.hpp"});
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
          std::set<std::string>{"0_visibility.glsl", "1_bilateral_x.glsl", "2_bilateral_y.glsl"});
    for (const std::string& name : files_in(folder / "out")) {
        const std::string glsl = content_of(folder / ("out/" + name));
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
        CHECK(files.size() == composed->view().passes.size());
        std::size_t geometry = 0;
        for (const std::string& file : files)
            geometry += file.ends_with(".glsl");
        CHECK(geometry == 1);
    }
    const temporary_folder folder;
    CHECK(emitted(layered + " --format header --name shaders", folder) ==
          std::set<std::string>{"shaders.hpp"});
    const std::string header = content_of(folder / "out/shaders.hpp");
    CHECK(header.find("constexpr char capture_layers[] =\n    \"// ") != std::string::npos);
    CHECK(header.find("constexpr std::uint32_t visibility[] = {\n    0x07230203, ") != std::string::npos);
}
