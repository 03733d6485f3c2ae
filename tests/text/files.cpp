// SPDX-License-Identifier: MIT
// Each GLSL file compiles alone, beside the types and prototypes that it states it calls.
#include <crease/crease.hpp>
#include <crease/spirv.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
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

// What the interface of a program declares for its files.
constexpr std::string_view version = "#version 450\n";
constexpr std::string_view prelude = R"(#define crease_unroll
const int crease_divisor = 1;
const int crease_workgroup_columns = 16;
const int crease_input_divisor = 2;
int crease_view_index = 0;
#define crease_parameters_place std140, set = 0, binding = 0
layout(r32ui, set = 0, binding = 1) uniform readonly uimage2D crease_input;
)";
constexpr const char* workgroup = "layout(local_size_x = 16, local_size_y = 16) in;\n";

/// A resource as GLSL declares it.
std::string declared(const crease::resource& r, crease::access how, unsigned slot) {
    const crease::format_facts texels = crease::facts_of(r.texels);
    const std::string prefix = texels.whole_numbers ? "u" : "";
    const std::string shape = r.samples_by.number >= 0 ? "2DMS" : r.arrayed ? "2DArray" : "2D";
    const std::string place = "set = 0, binding = " + std::to_string(slot) + ") uniform " + prefix;
    const std::string name = " crease_" + std::string(r.name) + ";\n";
    if (how == crease::access::sample)
        return "layout(" + place + "sampler" + shape + name;
    return "layout(" + std::string(texels.glsl) + ", " + place + "image" + shape + name;
}

/// The resources of the parts that a file belongs to, as it uses them.
std::string resources_for(const std::string& file) {
    std::string text;
    std::set<std::string_view> known;
    unsigned slot = 10;
    for (const crease::part* p : crease::all_parts) {
        const auto is = [&file](const crease::glsl_file* f) { return f && f->name == file; };
        const auto add = [&](std::string_view name, bool stored) {
            for (const auto& list : {p->resources, p->intermediates})
                for (const crease::resource& r : list)
                    if (r.name == name && known.insert(name).second)
                        text += declared(r, stored ? crease::access::store : r.read, slot++);
        };
        bool owns = is(p->glsl);
        for (const crease::glsl_file* helper : p->helpers)
            owns = owns || is(helper);
        if (owns)
            for (const crease::resource& r : p->resources)
                add(r.name, false);
        for (const crease::step& s : p->steps) {
            bool in_step = is(s.body);
            for (const crease::glsl_file* helper : s.helpers)
                in_step = in_step || is(helper);
            if (!in_step)
                continue;
            for (std::string_view name : s.reads)
                add(name, false);
            for (std::string_view name : s.writes)
                add(name, true);
        }
        if (p->captures && is(p->captures->body) && p->captures->how == crease::access::modify)
            add(p->captures->writes, true);
    }
    return text;
}

/// The extension of the part that a file belongs to.
std::string extension_for(const std::string& file) {
    for (const crease::part* p : crease::all_parts)
        if (p->glsl && p->glsl->name == file && !p->extension.empty())
            return "#extension " + std::string(p->extension) + " : require\n";
    return "";
}

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

/// The structs that a file's prototypes name, each from a part that defines it.
std::string structs_for(const std::string& text) {
    std::string structs;
    const auto add = [&](std::string_view name, std::string_view file, std::string_view ends) {
        const std::string wanted = "struct " + std::string(name) + (name.ends_with(" ") ? "{" : " {");
        if (text.find(std::string(name)) == std::string::npos || text.find(wanted) != std::string::npos)
            return;
        const std::string from = read(fs::path(CREASE_TEMPLATES) / file);
        const std::size_t begin = from.find(wanted);
        const std::string found = from.substr(begin, from.find(ends, begin) + ends.size() - begin) + "\n";
        std::istringstream lines(from);
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with("const int ") &&
                found.find('[' + line.substr(10, line.find(' ', 10) - 10) + ']') != std::string::npos)
                structs += line + "\n"; // the size of an array in it
        structs += found;
    };
    const auto holds = [&](std::string_view word) { return text.find(word) != std::string::npos; };
    add("crease_result",
        holds("bent") || holds("_bend") ? "output/bent_cone_result.glsl"
        : holds("shade")                ? "output/shade_result.glsl"
                                        : "output/visibility_result.glsl",
        "};");
    add("crease_bend", "output/bent_cone_result.glsl", "};");
    add("crease_receiver", "core/receiver.glsl", "};");
    add("crease_gathered", "output/occlusion_alone.glsl", "};");
    add("crease_layers", "depth/single_layer.glsl", "};");
    add("crease_areas ", "depth/summed_area.glsl", "};");
    const bool in_space = holds("tap.offset") || holds("sphere_points");
    const bool lines = holds("tap.near") || holds("crease_line_chord");
    const bool areas = holds("vec4 area") || holds("crease_sample_area");
    add("crease_tap",
        in_space ? "sampler/point_tap.glsl"
        : lines  ? "sampler/line_tap.glsl"
        : areas  ? "sampler/area_tap.glsl"
                 : "sampler/screen_tap.glsl",
        "};");
    add("crease_pattern", "sampler/directions.glsl", "};");
    add("crease_estimate", holds("estimate.rounding") ? "estimator/ssao.glsl" : "estimator/hbao.glsl", "};");
    const bool plus = text.find("contribution.rise") != std::string::npos;
    const bool points = text.find("contribution.points") != std::string::npos;
    add("crease_contribution",
        plus     ? "estimator/hbao_plus.glsl"
        : points ? "estimator/ssao.glsl"
        : areas  ? "estimator/mean_height.glsl"
                 : "estimator/hbao.glsl",
        "};");
    add("crease_groups", "fold/groups.glsl", "};");
    add("crease_batch", "core/batch.glsl", "};");
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
        const crease::spirv::shader_stage stage = name.starts_with("capture/")
                                                      ? crease::spirv::shader_stage::fragment
                                                      : crease::spirv::shader_stage::compute;
        const std::string before = std::string(version) + extension_for(name) + std::string(prelude) +
                                   (stage == crease::spirv::shader_stage::compute ? workgroup : "") +
                                   constants() + resources_for(name);
        const std::string text = structs_for(own);
        const crease::piece pieces[] = {{"prelude", before}, crease::parameters_glsl,
                                        crease::types_glsl,  {"structs", text},
                                        {name, own},         {"end", "void main() {}\n"}};
        CHECK_NOTHROW(crease::spirv::detail::parse(pieces, stage, crease::dialect_kind::vulkan, name));
        ++files;
    }
    CHECK(files > 15);
}

TEST_CASE("an error names the file and its line") {
    const std::string wrong =
        read(fs::path(CREASE_TEMPLATES) / "noise/hashed_noise.glsl") + "float broken = nothing;\n";
    const crease::piece pieces[] = {{"interface",
                                     "#version 450\nconst int crease_view_index = 0;\n"
                                     "#define crease_parameters_place std140, set = 0, binding = 0\n"},
                                    crease::parameters_glsl,
                                    {"noise/hashed_noise.glsl", wrong},
                                    {"end", "void main() {}\n"}};
    const long line = std::count(wrong.begin(), wrong.end(), '\n');
    CHECK_THROWS_WITH_AS(crease::spirv::compile(pieces, crease::spirv::shader_stage::compute),
                         doctest::Contains(("noise/hashed_noise.glsl:" + std::to_string(line)).c_str()),
                         crease::spirv::error);
}
