// SPDX-License-Identifier: MIT
// Each GLSL file compiles alone, beside the types and prototypes that it states it calls.
#include <crease/crease.hpp>
#include <crease/spirv.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// What the interface of a program declares for its files, one of everything.
constexpr std::string_view prelude = R"(#version 450
const int crease_divisor = 1;
#define crease_view crease_views[0]
const int crease_view_index = 0;
const int crease_input_divisor = 2;
layout(set = 0, binding = 1) uniform sampler2D crease_depth;
layout(set = 0, binding = 2) uniform sampler2D crease_normal;
layout(set = 0, binding = 3) uniform usampler2D crease_input;
)";

/// The constants of all parts, which a file alone may name.
std::string constants() {
    std::string text;
    for (const crease::part* p : crease::all_parts) {
        for (const crease::number& n : p->numbers)
            text += "const int crease_" + std::string(p->name) + "_" + std::string(n.name) + " = " +
                    std::to_string(n.fallback) + ";\n";
        for (const crease::step& s : p->steps.first(p->steps.empty() ? 0 : 1))
            for (const crease::step_constant& c : s.constants)
                text += "const int crease_" + std::string(p->name) + "_" + std::string(c.name) + " = 0;\n";
    }
    return text;
}

/// The structs that a file's prototypes name, each from a part that defines it.
std::string structs_for(const std::string& text) {
    std::string structs;
    const auto add = [&](std::string_view name, std::string_view file, std::string_view ends) {
        const std::string wanted = "struct " + std::string(name) + " {";
        if (text.find(std::string(name)) == std::string::npos || text.find(wanted) != std::string::npos)
            return;
        const std::string from = read(fs::path(CREASE_TEMPLATES) / file);
        const std::size_t begin = from.find(wanted);
        structs += from.substr(begin, from.find(ends, begin) + ends.size() - begin) + "\n";
    };
    const auto holds = [&](std::string_view word) { return text.find(word) != std::string::npos; };
    add("crease_result", holds("shade") ? "output/shade_result.glsl" : "output/visibility_result.glsl", "};");
    add("crease_receiver", "core/receiver.glsl", "};");
    add("crease_gathered", "output/visibility_only.glsl", "};");
    add("crease_layers", "depth/single_layer.glsl", "};");
    const bool points = holds(".point") || holds("sphere_points");
    const bool lines = holds("tap.near") || holds("crease_line_clip");
    add("crease_tap",
        points  ? "sampler/point_tap.glsl"
        : lines ? "sampler/line_tap.glsl"
                : "sampler/screen_tap.glsl",
        "};");
    add("crease_pattern", "sampler/directions.glsl", "};");
    add("crease_estimate", "estimator/hbao.glsl", "};");
    add("crease_contribution", "estimator/hbao.glsl", "};");
    return structs;
}

}

TEST_CASE("each GLSL file alone") {
    unsigned files = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(CREASE_TEMPLATES)) {
        const std::string name = fs::relative(entry.path(), CREASE_TEMPLATES).generic_string();
        if (entry.path().extension() != ".glsl" || name.starts_with("core/parameters") ||
            name.starts_with("core/types") || name.starts_with("stage/"))
            continue; // these two stand before every other; a stage is whole only in its program
        CAPTURE(name);
        const std::string own = read(entry.path());
        CHECK(own.size() <= crease::glsl_file::longest);
        const std::string before = std::string(prelude) + constants() +
                                   "#define crease_parameters_place std140, set = 0, binding = 0\n";
        const std::string text = structs_for(own);
        const crease::piece pieces[] = {{"prelude", before}, crease::parameters_glsl,
                                        crease::types_glsl,  {"structs", text},
                                        {name, own},         {"end", "void main() {}\n"}};
        CHECK_NOTHROW(crease::spirv::detail::parse(pieces, crease::spirv::shader_stage::compute,
                                                   crease::dialect_kind::vulkan, name));
        ++files;
    }
    CHECK(files > 15);
}

TEST_CASE("an error names the file and its line") {
    const std::string wrong =
        read(fs::path(CREASE_TEMPLATES) / "noise/hashed_noise.glsl") + "float broken = nothing;\n";
    const crease::piece pieces[] = {
        {"interface", "#version 450\n#define crease_parameters_place std140, set = 0, binding = 0\n"},
        crease::parameters_glsl,
        {"noise/hashed_noise.glsl", wrong},
        {"end", "void main() {}\n"}};
    const long line = std::count(wrong.begin(), wrong.end(), '\n');
    CHECK_THROWS_WITH_AS(crease::spirv::compile(pieces, crease::spirv::shader_stage::compute),
                         doctest::Contains(("noise/hashed_noise.glsl:" + std::to_string(line)).c_str()),
                         crease::spirv::error);
}
