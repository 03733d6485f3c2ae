// SPDX-License-Identifier: MIT
// The parts in docs/parts.md compose with those of crease, compile, and find the step in a wall.
#include "step.hpp"

#include <crease/crease.hpp>
#include <crease/spirv.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <regex>

#include "parts.inc"

namespace {

std::string text_of_page() {
    std::ifstream file(CREASE_PAGES "/docs/parts.md");
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The page's parts all in one effect.
using all_own = crease::effect<parts_page::cross<6>, parts_page::slab, parts_page::nearness,
                               parts_page::box_blur, parts_page::one_normal, parts_page::interleaved_noise,
                               parts_page::first_layer, parts_page::near_receivers, parts_page::darkness,
                               parts_page::loads, parts_page::flat_groups, parts_page::millimetres>;
using all_own_captured =
    crease::effect<parts_page::cross<6>, crease::stochastic_layers<8>, parts_page::nearness,
                   parts_page::checkered, parts_page::depth_buffer, parts_page::first_layer>;

/// Compiles each pass, as what is declared of it.
void check_programs(const crease::effect_view& effect) {
    for (const crease::pass& each : effect.passes) {
        CAPTURE(std::string(each.name));
        std::vector<crease::piece> pieces(each.pieces.begin(), each.pieces.end());
        if (each.stage == crease::stage_kind::geometry) {
            pieces.insert(pieces.begin(), {"version", "#version 450\n"});
            pieces.push_back(step::fragment_of(each)[0]);
        }
        if (each.dialect == crease::dialect_kind::opengl) {
            CHECK_NOTHROW(crease::spirv::check_opengl(each));
            continue;
        }
        const crease::spirv::words module = crease::spirv::compile(
            pieces, each.stage == crease::stage_kind::compute ? crease::spirv::shader_stage::compute
                                                              : crease::spirv::shader_stage::fragment);
        CHECK_NOTHROW(crease::spirv::validate(module));
        const std::vector<std::string> differences =
            crease::spirv::mismatches(effect, each, crease::spirv::reflect(module));
        CHECK_MESSAGE(differences.empty(), (differences.empty() ? std::string() : differences[0]));
    }
}

/// An effect at run time is the same as at compile time, byte for byte.
template <class Effect, std::size_t... Pass>
void check_composition(std::index_sequence<Pass...>) {
    const auto composed = std::make_unique<crease::composition>(crease::recipe(Effect::choices));
    REQUIRE_MESSAGE(static_cast<bool>(*composed), composed->error());
    REQUIRE(composed->view().passes.size() == sizeof...(Pass));
    CHECK(((step::joined(composed->view().passes[Pass].pieces) == Effect::template source<Pass>()) && ...));
}

template <class Effect>
std::vector<float> check(const char* image = "visibility", bool is_orthographic = false) {
    check_programs(Effect::view());
    check_composition<Effect>(std::make_index_sequence<Effect::passes.size()>());
    const std::vector<float> all = step::run(Effect::view(), image, is_orthographic);
    REQUIRE(all.size() == step::width * step::height);
    CHECK(std::ranges::all_of(all, [](float each) { return each >= 0 && each <= 1; }));
    const bool is_darkness = std::string(image) == "darkness";
    const auto mean_of_column = [&](unsigned column) {
        float sum = 0;
        for (unsigned row = 0; row < step::height; ++row)
            sum += all[row * step::width + column] / step::height;
        return is_darkness ? 1 - sum : sum;
    };
    const float beside = mean_of_column(step::width / 2), above = mean_of_column(step::width / 2 - 1),
                open = mean_of_column(step::width - 2);
    CAPTURE(beside);
    CAPTURE(above);
    CAPTURE(open);
    CHECK(beside < above - 0.03f);
    CHECK(beside < open - 0.03f);
    CHECK(open > 0.9f);
    return all;
}

}

TEST_CASE("the page has a section and a part for each role") {
    const std::string page = text_of_page();
    std::size_t before = 0;
    for (std::size_t i = 0; i < crease::role_count; ++i) {
        const std::string name(crease::name_of(static_cast<crease::role>(i)));
        CAPTURE(name);
        const std::size_t at = page.find("\n### " + name + "\n");
        REQUIRE(at != std::string::npos);
        CHECK(at > before); // in the order of roles
        const std::size_t end = std::min(page.find("\n### ", at + 1), page.find("\n## ", at + 1));
        std::string kind = name;
        std::ranges::replace(kind, ' ', '_');
        CHECK(page.substr(at, end - at).find(".kind = crease::role::" + kind) != std::string::npos);
        before = at;
    }
}

TEST_CASE("each section tells of all that its part defines") {
    const std::string page = text_of_page();
    const std::regex block("```cpp\\n[^`]*```"),
        defined("\\n(?:struct|const int|[a-z][a-z0-9_]*) (crease_[a-z0-9_]+)");
    unsigned definitions = 0;
    for (std::size_t i = 0; i < crease::role_count; ++i) {
        const std::string name(crease::name_of(static_cast<crease::role>(i)));
        const std::size_t at = page.find("\n### " + name + "\n");
        const std::string section = page.substr(at, page.find("\n##", at + 4) - at);
        const std::string prose = std::regex_replace(section, block, "");
        std::smatch own;
        REQUIRE(std::regex_search(section, own, std::regex("\\.name = \"([a-z_]+)\",\n +\\.summary")));
        for (std::sregex_iterator each(section.begin(), section.end(), defined), end; each != end; ++each) {
            const std::string found = (*each)[1];
            CAPTURE(found);
            ++definitions;
            CHECK((found.starts_with("crease_" + own[1].str() + "_") ||
                   prose.find(found) != std::string::npos));
        }
    }
    CHECK(definitions > 50);
}

TEST_CASE("the page names every part") {
    const std::string page = text_of_page();
    for (const crease::part* each : crease::all_parts) {
        const std::string name(each->name);
        CAPTURE(name);
        // The structs of dialects that are named after an API have longer names.
        CHECK((page.find("`" + name + "`") != std::string::npos ||
               page.find("`" + name + "_glsl`") != std::string::npos));
    }
}

TEST_CASE("projection") {
    check<parts_page::with_plan_view>("visibility", true);
}
TEST_CASE("depth encoding") {
    check<parts_page::with_millimetres>();
}
TEST_CASE("normals") {
    check<parts_page::with_one_normal>();
}
TEST_CASE("noise") {
    check<parts_page::with_interleaved_noise>();
}
TEST_CASE("further views") {
    check<parts_page::with_darker_view>();
}
TEST_CASE("coverage") {
    check<parts_page::with_checkered>();
}
TEST_CASE("layer storage") {
    check<parts_page::with_depth_buffer>();
}
TEST_CASE("scan") {
    check<parts_page::with_plain_scan>();
}
TEST_CASE("depth source") {
    check<parts_page::with_slab>();
    check<parts_page::with_nearest_nodes>();
}
TEST_CASE("resolutions") {
    check<parts_page::with_near_and_far>();
}
TEST_CASE("sampler") {
    check<parts_page::with_cross>();
}
TEST_CASE("estimator") {
    check<parts_page::with_nearness>();
}
TEST_CASE("layer traversal") {
    check<parts_page::with_first_layer>();
}
TEST_CASE("receivers") {
    check<parts_page::with_near_receivers>();
}
TEST_CASE("output") {
    check<parts_page::with_darkness>("darkness");
}
TEST_CASE("output format") {
    const std::vector<float> all = check<parts_page::with_exact>();
    CHECK(std::ranges::any_of(all, [](float each) { return each * 255 != std::round(each * 255); }));
}
TEST_CASE("filter") {
    check<parts_page::with_box_blur>();
}
TEST_CASE("stage") {
    check<parts_page::with_flat_groups>();
}
TEST_CASE("all the page's parts together") {
    check<all_own>("darkness");
    check<all_own_captured>();
}

TEST_CASE("image reads") {
    using with_fetches =
        crease::effect<crease::directions<4, 4>, crease::single_layer, crease::hbao, crease::bilateral<>>;
    CHECK(check<parts_page::with_loads>() == check<with_fetches>());
}

TEST_CASE("dialect") {
    check_programs(parts_page::with_desktop_gl::view());
}

TEST_CASE("a recipe may name the host's parts") {
    REQUIRE_MESSAGE(static_cast<bool>(parts_page::from_text), parts_page::from_text.error());
    CHECK(parts_page::from_text.text().view() == "poisson_disk:16/single_layer/nearness");
}
