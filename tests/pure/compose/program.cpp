// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "compositions.hpp"
#include "text.hpp"

#include <doctest/doctest.h>

#include <array>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>

namespace {

using namespace crease;

std::size_t count_of(std::string_view text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos;
         at = text.find(part, at + part.size()))
        ++count;
    return count;
}

bool has_main(const pass& each) {
    return each.stage == stage_kind::compute || each.stage == stage_kind::fragment;
}

void check_pass(const pass& each) {
    CHECK(each.pieces[0].name == "interface");
    const std::string text = joined(each.pieces);
    CHECK_FALSE(contains(text, "__cplusplus"));
    // Nothing may stand before the version in GLSL ES.
    CHECK(text.starts_with(has_main(each) && each.dialect == dialect_kind::glsl_es ? "#version 310 es\n// "
                                                                                   : "// "));
    CHECK(count_of(text, "SPDX-License-Identifier") == 1);
    const bool builds = each.bindings.back().name != "output" && each.stage == stage_kind::compute &&
                        !contains(text, "crease_evaluate");
    const std::string_view does = each.takes_surfaces
                                      ? "void crease_capture(vec3 anchor, vec3 normal, vec4 color) {"
                                  : each.stage == stage_kind::geometry ? "void crease_capture(vec3 anchor) {"
                                  : builds                             ? "void crease_build"
                                           : "crease_result crease_evaluate(ivec2 pixel) {";
    CHECK(count_of(text, does) >= 1);
    CHECK(count_of(text, "#version") == (has_main(each) ? 1 : 0));
    CHECK(count_of(text, "void main()") == (has_main(each) ? 1 : 0));
    for (const piece& file : each.pieces)
        CHECK(file.text.ends_with("\n"));
    CHECK(each.vertex_pieces.empty() == (each.stage != stage_kind::fragment));
}

bool has_sets(dialect_kind dialect) {
    return dialect == dialect_kind::vulkan || dialect == dialect_kind::webgpu;
}

/// What shares numbers: in Vulkan and WebGPU all that has a descriptor; in OpenGL blocks, textures, images
/// and buffers apart. The places of attachments and results count apart from all.
int counted_with(const effect_view& view, const binding& b, dialect_kind dialect) {
    if (!has_descriptor(b.how))
        return b.how == access::attachment ? -1 : -2;
    if (has_sets(dialect) || b.how == access::uniform)
        return 0;
    if (view.resources[b.resource].kind == resource_kind::buffer)
        return 3;
    return b.how == access::sample ? 1 : 2;
}

/// The line of a program's interface that declares a binding.
std::string declaration(std::string_view interface, const binding& b, resource_kind kind) {
    const std::string name = b.how == access::uniform        ? " uniform crease_parameters {\n"
                             : kind == resource_kind::buffer ? " crease_" + std::string(b.name) + "[]; };\n"
                                                             : " crease_" + std::string(b.name) + ";\n";
    const std::size_t at = interface.find(name);
    if (at == std::string_view::npos)
        return {};
    const std::size_t begin = interface.rfind('\n', at) + 1;
    return std::string(interface.substr(begin, interface.find('\n', at) - begin)) + '\n';
}

void check_bindings(const effect_view& view, const pass& each) {
    const unsigned first = each.bindings.front().slot;
    CHECK((each.stage == stage_kind::functions || first == 0));
    std::map<int, unsigned> next{{-2, 0}, {-1, 0}, {0, first}, {1, first}, {2, first}, {3, first}};
    for (const binding& b : each.bindings) {
        CHECK(b.resource < view.resources.size());
        CHECK(b.slot == next[counted_with(view, b, each.dialect)]++); // none is left out and none taken twice
        CHECK((b.how == access::uniform) == (b.resource == 0));
        if (!has_descriptor(b.how))
            continue;
        CAPTURE(std::string(b.name));
        const std::string text = declaration(each.pieces[0].text, b, view.resources[b.resource].kind);
        CHECK(contains(text, "binding = " + std::to_string(b.slot) + ")"));
        CHECK(contains(text, "set = " + std::to_string(b.set) + ", ") == has_sets(each.dialect));
    }
    CHECK(writes(each.bindings.back().how));
}

void check_constants(const pass& each) {
    std::set<unsigned> ids;
    for (const constant& c : each.constants)
        CHECK(ids.insert(c.id).second);
}

/// The interface of a pass of a recipe.
std::string interface_of(std::string_view recipe_text, std::size_t which) {
    const auto composed = std::make_unique<composition>(recipe(recipe_text));
    REQUIRE(which < composed->view().passes.size());
    return std::string(composed->view().passes[which].pieces[0].text);
}

void check_declares(std::string_view recipe_text, std::size_t which,
                    std::initializer_list<std::string_view> lines) {
    const std::string interface = interface_of(recipe_text, which);
    CAPTURE(interface);
    for (std::string_view line : lines)
        CHECK(contains(interface, std::string(line) + "\n"));
}

}

TEST_CASE("legal compositions are whole, and its bindings and constants are distinct") {
    const std::vector<std::string> all = every_recipe();
    CHECK(all.size() >= 20000);
    std::set<std::string> seen; // many share passes to the letter
    for (const std::string& text : all) {
        CAPTURE(text);
        const auto composed = std::make_unique<composition>(recipe(text));
        const effect_view view = composed->view();
        CAPTURE(std::string(composed->error()));
        REQUIRE_FALSE(view.passes.empty());
        CHECK(view.resources.front().name == "parameters");
        CHECK(view.resources.back().life == lifetime::output);
        for (const pass& each : view.passes) {
            const std::string_view interface = each.pieces[0].text;
            if (!seen.insert(std::string(interface.substr(interface.find('\n')))).second)
                continue;
            check_pass(each);
            check_bindings(view, each);
            check_constants(each);
        }
    }
}

TEST_CASE("the longest names and numbers fit") {
    const std::string text =
        "directions:64x64x4/stochastic_layers:32/hbao/deferred_layers:1x4/bent_cone/"
        "atomic_minimum:31x1023x1023/bilateral:16/upsample:8/compute:1024x1024/tiled_noise:16";
    const auto composed = std::make_unique<composition>(recipe(std::string_view(text)));
    CHECK(composed->error().empty());
}

TEST_CASE("a program has no definition twice, and each after those that it calls") {
    for (const char* text :
         {"directions:8x4/stochastic_layers/hbao_plus/bent_cone/second_view/atomic_minimum",
          "directions:8x4/stochastic_layers/hbao/deferred_layers/bent_cone/bilateral/upsample",
          "sample_box/summed_area_adaptive/mean_height/fragment", "directions/single_layer/hbao/functions"}) {
        CAPTURE(text);
        const auto composed = std::make_unique<composition>(recipe(std::string_view(text)));
        REQUIRE(*composed);
        for (const pass& each : composed->view().passes) {
            std::set<symbol> all, defined;
            std::vector<std::unique_ptr<symbol_table>> tables;
            std::vector<glsl_file> files;
            files.reserve(each.pieces.size());
            for (std::size_t i = 1; i < each.pieces.size(); ++i) {
                const glsl_file& file = files.emplace_back(each.pieces[i].name, each.pieces[i].text);
                tables.push_back(std::make_unique<symbol_table>(read_symbols(file)));
                REQUIRE(tables.back()->definitions.size() == 1);
                CHECK(all.insert(tables.back()->definitions[0].name).second);
            }
            for (const auto& table : tables) {
                CAPTURE(std::string(table->file->text));
                defined.insert(table->definitions[0].name);
                for (symbol reference : table->references)
                    CHECK((!all.contains(reference) || defined.contains(reference)));
            }
        }
    }
}

TEST_CASE("the line of each piece is that of its file") {
    const auto composed =
        std::make_unique<composition>(recipe("directions:8x4/stochastic_layers/hbao/bent_cone/bilateral"));
    for (const pass& each : composed->view().passes)
        for (std::size_t i = 1; i < each.pieces.size(); ++i) {
            const piece& own = each.pieces[i];
            CAPTURE(std::string(own.name));
            std::ifstream file(CREASE_TEMPLATES "/" + std::string(own.name));
            std::string all, line;
            for (unsigned number = 1; std::getline(file, line); ++number)
                if (number >= own.first_line)
                    all += line + "\n";
            CHECK(all.starts_with(own.text));
        }
}

TEST_CASE("the host places the bindings and constants of functions") {
    check_declares("directions:8x4/single_layer/hbao/functions:2x5x40", 0,
                   {"layout(constant_id = 40) const int crease_directions_count = 8;",
                    "layout(std140, set = 2, binding = 5) uniform crease_parameters {",
                    "layout(set = 2, binding = 6) uniform sampler2D crease_depth;"});
}

TEST_CASE("the host places the bindings and constants of a geometry pass") {
    check_declares("directions/stochastic_layers:6/hbao/simple_hash/atomic_minimum:1x2x3", 0,
                   {"layout(constant_id = 3) const int crease_stochastic_layers_count = 6;",
                    "layout(std140, set = 1, binding = 2) uniform crease_parameters {",
                    "layout(r32ui, set = 1, binding = 3) uniform uimage2DArray crease_captured_layers;"});
}

TEST_CASE("OpenGL counts blocks, textures and images apart, and has plain constants") {
    const std::string text = interface_of("directions:8x4/single_layer/hbao/opengl", 0);
    CHECK(has_version(text, "#version 430\n"));
    CHECK(contains(text, "\nconst int crease_directions_count = 8;"));
    CHECK(contains(text, "layout(std140, binding = 0) uniform crease_parameters {"));
    CHECK(contains(text, "layout(binding = 0) uniform sampler2D crease_depth;"));
    CHECK(contains(text, "layout(r8, binding = 0) uniform writeonly image2D crease_output;"));
    CHECK_FALSE(contains(text, "set ="));
    CHECK_FALSE(contains(text, "_id"));
}

TEST_CASE("OpenGL's images share their units, whether they are loaded, stored or changed") {
    check_declares("directions/single_layer/hbao/bent_cone/bilateral/image_load/opengl", 2,
                   {"layout(std140, binding = 0) uniform crease_parameters {",
                    "layout(rg32ui, binding = 0) uniform readonly uimage2D crease_input;",
                    "layout(r8, binding = 1) uniform writeonly image2D crease_output;",
                    "layout(rgba16f, binding = 2) uniform writeonly image2D crease_bent_cone;"});
    check_declares("sample_box/summed_area_adaptive/mean_height/image_load/opengl", 4,
                   {"layout(binding = 0) uniform sampler2D crease_depth;",
                    "layout(rgba32f, binding = 0) uniform readonly image2DArray crease_area_tables;",
                    "layout(rgba32f, binding = 1) uniform readonly image2D crease_range;",
                    "layout(rgba32f, binding = 2) uniform writeonly image2DArray crease_area_splits;"});
    check_declares("directions/linear_lists/hbao/opengl", 1,
                   {"layout(r32ui, binding = 0) uniform uimage2DArray crease_list_places;"});
}

TEST_CASE("what passes write is fetched by later ones, or loaded as an image, by the part of that role") {
    check_declares("directions/single_layer/hbao/bilateral", 1,
                   {"layout(set = 0, binding = 1) uniform usampler2D crease_input;",
                    "uvec4 crease_load_input(ivec2 texel) { return texelFetch(crease_input, texel, 0); }"});
    check_declares("directions/single_layer/hbao/bilateral/image_load", 1,
                   {"layout(r32ui, set = 0, binding = 1) uniform readonly uimage2D crease_input;",
                    "uvec4 crease_load_input(ivec2 texel) { return imageLoad(crease_input, texel); }"});
    check_declares("directions/stochastic_layers/hbao", 2,
                   {"vec4 crease_load_packed_layers(ivec3 texel) { return texelFetch(crease_packed_layers, "
                    "texel, 0); }"});
}

TEST_CASE("a program has the settings that it reads, and its block all of the effect's") {
    const std::string text = interface_of("directions/single_layer/hbao/bilateral", 1);
    CHECK(contains(text, "    float bilateral_sharpness;\n"));
    CHECK(contains(text, "    float hbao_bias;\n"));
    CHECK(contains(text, "    float strength;\n} crease_given;\n") !=
          contains(text, "    float bilateral_sharpness;\n} crease_given;\n"));
    CHECK(contains(text, "\nfloat crease_bilateral_sharpness = crease_given.bilateral_sharpness;\n"));
    CHECK_FALSE(contains(text, "crease_hbao_bias"));
    CHECK_FALSE(contains(text, "crease_strength"));
    CHECK_FALSE(contains(text, "crease_frame"));
}

TEST_CASE("a program that reads no parameters has no block of them") {
    const auto composed =
        std::make_unique<composition>(recipe("box_window/single_layer/unsharp_mask/linear_depth"));
    const auto areas = std::make_unique<composition>(recipe("sample_box/mip_chain:3/mean_height"));
    for (const effect_view& view : {composed->view(), areas->view()})
        for (const pass& each : view.passes) {
            CAPTURE(std::string(each.name));
            const bool has_block = each.bindings.front().name == "parameters";
            CHECK(contains(joined(each.pieces), "crease_given.") == has_block);
            CHECK(contains(each.pieces[0].text, "crease_parameters") == has_block);
        }
    CHECK(areas->view().passes[3].bindings.front().name != "parameters"); // a level of the one before
}

TEST_CASE("two cameras have two views in the block, and a program for both begins with the first") {
    check_declares(
        "directions/stochastic_layers/hbao_plus/second_view", 4,
        {"    crease_view_parameters views[2];", "    mat4 from_first[1];", "int crease_view_index = 0;"});
    check_declares("directions/stochastic_layers/hbao_plus/second_view", 3,
                   {"const int crease_view_index = 1;"});
    CHECK_FALSE(contains(interface_of("directions/stochastic_layers/hbao_plus", 2), "from_first"));
}

TEST_CASE("as many files as there is room for are not too many, one more is") {
    static constexpr glsl_file empty("engine/empty.glsl", "");
    static std::array<const glsl_file*, file_list::capacity + 1> many;
    many.fill(&empty);
    const plan p = make_plan(recipe("directions/single_layer/hbao").choices());
    const std::size_t others = files_of(p, p.passes[0]).size();
    const auto refused = [&](std::size_t count) {
        const part noise{
            .kind = role::noise, .name = "own", .summary = "", .source = "", .files = {many.data(), count}};
        const part* const known[] = {&directions_part::description, &single_layer::description,
                                     &hbao::description, &noise};
        const recipe with_own("directions/single_layer/hbao/own", known);
        const auto composed = std::make_unique<composition>(with_own);
        return std::string(composed->error());
    };
    // All of hashed_noise's go.
    const std::size_t room = file_list::capacity - others + hashed_noise::description.files.size();
    CHECK_FALSE(contains(refused(room), rules::short_programs));
    CHECK(contains(refused(room + 1), rules::short_programs));
}
