// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "compositions.hpp"
#include "text.hpp"

#include <doctest/doctest.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>

namespace {

using namespace crease;

void check_pass(const pass& each) {
    CHECK(each.pieces[0].name == "interface");
    const std::string text = joined(each.pieces);
    CHECK_FALSE(contains(text, "__cplusplus"));
    const bool builds = each.bindings.back().name != "output" && each.stage == stage_kind::compute &&
                        !contains(text, "crease_evaluate");
    CHECK(contains(text, builds ? "void crease_build" : "crease_result crease_evaluate(ivec2 pixel) {"));
    CHECK(contains(text, "#version") == (each.stage != stage_kind::functions));
    CHECK(contains(text, "void main()") == (each.stage != stage_kind::functions));
    for (const piece& file : each.pieces) {
        CHECK(file.text.size() <= glsl_file::longest);
        CHECK(file.text.ends_with("\n"));
    }
    CHECK(each.vertex_pieces.empty() == (each.stage != stage_kind::fragment));
}

/// What shares numbers: in Vulkan all that has a descriptor; in OpenGL blocks, textures and images apart. The
/// places of attachments and results count apart from both.
int counted_with(const binding& b, dialect_kind dialect) {
    if (!has_descriptor(b.how))
        return -1;
    if (dialect == dialect_kind::vulkan || b.how == access::uniform)
        return 0;
    return b.how == access::sample ? 1 : 2;
}

/// The line of a program's interface that declares a binding.
std::string_view declaration(std::string_view interface, const binding& b) {
    const std::string end = b.how == access::uniform ? "#define crease_parameters_place "
                                                     : " crease_" + std::string(b.name) + ";\n";
    const std::size_t at = interface.find(end);
    if (at == std::string_view::npos)
        return {};
    const std::size_t begin = interface.rfind('\n', at) + 1;
    return interface.substr(begin, interface.find('\n', at) - begin);
}

void check_bindings(const pass& each, std::size_t resources) {
    const unsigned first = each.bindings.front().slot;
    CHECK((each.stage == stage_kind::functions || first == 0));
    std::map<int, unsigned> next{{-1, 0}, {0, first}, {1, first}, {2, first}};
    for (const binding& b : each.bindings) {
        CHECK(b.resource < resources);
        CHECK(b.slot == next[counted_with(b, each.dialect)]++); // none is left out and none taken twice
        if (!has_descriptor(b.how))
            continue;
        const std::string text = std::string(declaration(each.pieces[0].text, b)) + '\n';
        const std::string place = "binding = " + std::to_string(b.slot);
        CHECK((contains(text, place + ")") || contains(text, place + "\n")));
        CHECK(contains(text, "set = " + std::to_string(b.set) + ", ") ==
              (each.dialect == dialect_kind::vulkan));
    }
    CHECK(each.bindings.front().name == "parameters");
    CHECK(writes(each.bindings.back().how));
}

void check_constants(const pass& each) {
    std::set<unsigned> ids;
    for (const constant& c : each.constants)
        CHECK(ids.insert(c.id).second);
}

}

TEST_CASE("legal compositions are whole, and its bindings and constants are distinct") {
    const std::vector<std::string> all = every_recipe();
    CHECK(all.size() >= 4 * 7 * 8 * 6);
    for (const std::string& text : all) {
        CAPTURE(text);
        const auto composed = std::make_unique<composition>(recipe(text));
        const effect_view view = composed->view();
        REQUIRE_FALSE(view.passes.empty());
        CHECK(view.resources.front().name == "parameters");
        CHECK(view.resources.back().life == lifetime::output);
        for (const pass& each : view.passes) {
            check_pass(each);
            check_bindings(each, view.resources.size());
            check_constants(each);
        }
    }
}

TEST_CASE("the interface never outgrows its buffer") {
    const plan p = make_plan(
        recipe("directions:64x64/single_layer/hbao/bilateral:16/upsample:8/compute:1024x1024").choices());
    for (std::size_t i = 0; i < p.passes.size(); ++i)
        CHECK(write_program(p, p.passes[i]).interface.size() <= interface_text::most_characters);
}

TEST_CASE("the host places the bindings and constants of functions") {
    const composition composed(recipe("directions:8x4/single_layer/hbao/functions:2x5x40"));
    const pass& only = composed.view().passes[0];
    CHECK(contains(only.pieces[0].text, "layout(constant_id = 40) const int crease_directions_count = 8;"));
    CHECK(contains(only.pieces[0].text, "crease_parameters_place std140, set = 2, binding = 5"));
    CHECK(contains(only.pieces[0].text, "layout(set = 2, binding = 6) uniform sampler2D crease_depth;"));
}

TEST_CASE("OpenGL counts blocks, textures and images apart, and has plain constants") {
    const composition composed(recipe("directions:8x4/single_layer/hbao/opengl"));
    const std::string_view text = composed.view().passes[0].pieces[0].text;
    CHECK(text.starts_with("#version 430\n"));
    CHECK(contains(text, "\nconst int crease_directions_count = 8;"));
    CHECK(contains(text, "crease_parameters_place std140, binding = 0"));
    CHECK(contains(text, "layout(binding = 0) uniform sampler2D crease_depth;"));
    CHECK(contains(text, "layout(r8, binding = 0) uniform writeonly image2D crease_output;"));
    CHECK_FALSE(contains(text, "set ="));
    CHECK_FALSE(contains(text, "_id"));
}

TEST_CASE("OpenGL's images share their units, whether they are loaded, stored or changed") {
    const auto declares = [](std::string_view recipe_text, std::size_t which,
                             std::initializer_list<std::string_view> lines) {
        const auto composed = std::make_unique<composition>(recipe(recipe_text));
        const pass& each = composed->view().passes[which];
        CAPTURE(std::string(each.pieces[0].text));
        for (std::string_view line : lines)
            CHECK(contains(each.pieces[0].text, std::string(line) + "\n"));
    };
    declares("directions/single_layer/hbao/bent_cone/bilateral/opengl", 2,
             {"#define crease_parameters_place std140, binding = 0",
              "layout(rg32ui, binding = 0) uniform readonly uimage2D crease_input;",
              "layout(r8, binding = 1) uniform writeonly image2D crease_output;",
              "layout(rgba16f, binding = 2) uniform writeonly image2D crease_bent_cone;"});
    declares("sample_box/summed_area_adaptive/mean_height/opengl", 4,
             {"layout(binding = 0) uniform sampler2D crease_depth;",
              "layout(rgba32f, binding = 0) uniform readonly image2D crease_range;",
              "layout(rgba32f, binding = 1) uniform image2DArray crease_area_tables;"});
    declares("sample_box/summed_area/mean_height/opengl", 4,
             {"layout(binding = 0) uniform sampler2D crease_depth;",
              "layout(rgba32f, binding = 0) uniform readonly image2DArray crease_area_tables;",
              "layout(rgba32f, binding = 1) uniform readonly image2D crease_range;",
              "layout(binding = 1) uniform sampler2D crease_normal;",
              "layout(r8, binding = 2) uniform writeonly image2D crease_output;"});
}
