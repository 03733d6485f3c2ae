// SPDX-License-Identifier: MIT
// Each GLSL file compiles alone, beside the types and prototypes that it states it calls.
#include <crease/crease.hpp>
#include <crease/spirv.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
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
layout(local_size_x = 16, local_size_y = 16) in;
const int crease_divisor = 1;
#define crease_view crease_views[0]
const int crease_view_index = 0;
const int crease_input_divisor = 2;
layout(set = 0, binding = 1) uniform usampler2D crease_input;
)";

/// The constants of all parts, which a file alone may name.
std::string constants() {
    std::string text;
    std::set<std::string> of_steps;
    for (const crease::part* p : crease::all_parts) {
        for (const crease::number& n : p->numbers)
            text += "const int crease_" + std::string(p->name) + "_" + std::string(n.name) + " = " +
                    std::to_string(n.fallback) + ";\n";
        for (const crease::step& s : p->steps)
            for (const crease::step_constant& c : s.constants)
                of_steps.insert(std::string(c.of.empty() ? p->name : c.of) + "_" + std::string(c.name));
    }
    for (const std::string& name : of_steps)
        text += "const int crease_" + name + " = 1;\n";
    return text;
}

/// The images of all parts that a file names: stored to where it does so, else sampled.
std::string images_for(const std::string& text) {
    std::map<std::string, crease::resource> named;
    for (const crease::part* p : crease::all_parts)
        for (const auto& list : {p->resources, p->intermediates})
            for (const crease::resource& r : list)
                if (text.find("(crease_" + std::string(r.name) + ",") != std::string::npos)
                    named.emplace(r.name, r);
    std::string images;
    unsigned binding = 2;
    for (const auto& [name, r] : named) {
        const crease::format_facts facts = crease::facts_of(r.texels);
        const bool stored = text.find("imageStore(crease_" + name) != std::string::npos ||
                            text.find("imageLoad(crease_" + name) != std::string::npos;
        images += "layout(set = 0, binding = " + std::to_string(binding++) +
                  (stored ? ", " + std::string(facts.glsl) : "") + ") uniform " +
                  (facts.whole_numbers ? "u" : "") + (stored ? "image" : "sampler") +
                  (r.samples > 1 ? "2DMS"
                   : r.arrayed   ? "2DArray"
                                 : "2D") +
                  " crease_" + name + ";\n";
    }
    return images;
}

/// The structs that a file's prototypes name, each from a part that defines it.
std::string structs_for(const std::string& text) {
    std::string structs;
    const auto add = [&](std::string_view name, std::string_view file, std::string_view ends) {
        const std::string wanted = "struct " + std::string(name) + (name.ends_with(" ") ? "{" : " {");
        if (text.find(std::string(name)) == std::string::npos || text.find(wanted) != std::string::npos)
            return;
        const std::string from = read(fs::path(CREASE_TEMPLATES) / file);
        const std::size_t begin = from.find(wanted);
        structs += from.substr(begin, from.find(ends, begin) + ends.size() - begin) + "\n";
    };
    add("crease_result", "output/visibility_result.glsl", "};");
    add("crease_receiver", "core/receiver.glsl", "};");
    add("crease_gathered", "output/visibility_only.glsl", "};");
    add("crease_layers", "depth/single_layer.glsl", "};");
    add("crease_areas ", "depth/summed_area.glsl", "};");
    const bool points =
        text.find(".point") != std::string::npos || text.find("hemisphere") != std::string::npos;
    const bool areas = text.find("area") != std::string::npos;
    add("crease_tap",
        points  ? "sampler/point_tap.glsl"
        : areas ? "sampler/area_tap.glsl"
                : "sampler/screen_tap.glsl",
        "};");
    add("crease_pattern", "sampler/directions.glsl", "};");
    add("crease_estimate", "estimator/hbao.glsl", "};");
    add("crease_contribution", areas ? "estimator/mean_height.glsl" : "estimator/hbao.glsl", "};");
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
        const std::string before = std::string(prelude) + images_for(own) + constants() +
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
        read(fs::path(CREASE_TEMPLATES) / "core/noise.glsl") + "float broken = nothing;\n";
    const crease::piece pieces[] = {
        {"interface", "#version 450\n#define crease_parameters_place std140, set = 0, binding = 0\n"},
        crease::parameters_glsl,
        {"core/noise.glsl", wrong},
        {"end", "void main() {}\n"}};
    const long line = std::count(wrong.begin(), wrong.end(), '\n');
    CHECK_THROWS_WITH_AS(crease::spirv::compile(pieces, crease::spirv::shader_stage::compute),
                         doctest::Contains(("core/noise.glsl:" + std::to_string(line)).c_str()),
                         crease::spirv::error);
}
