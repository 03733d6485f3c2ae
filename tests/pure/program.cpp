// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "compositions.hpp"
#include "text.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <set>
#include <tuple>

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

void check_bindings(const pass& each, std::size_t resources) {
    std::set<std::tuple<unsigned, unsigned, int>> places;
    for (const binding& b : each.bindings) {
        CHECK(b.resource < resources);
        if (b.how == access::attachment || b.how == access::result)
            continue;
        const int counted_apart = each.dialect == dialect_kind::opengl ? static_cast<int>(b.how) : 0;
        CHECK(places.emplace(b.set, b.slot, counted_apart).second);
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
