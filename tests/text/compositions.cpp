// SPDX-License-Identifier: MIT
// Every legal composition compiles, is valid for Vulkan, has the interface that its effect declares, and
// nothing that it does not use.
#include "pure/compositions.hpp"
#include "text/host_program.hpp"
#include "text/seen_definitions.hpp"
#include "text/unused.hpp"

#include <crease/spirv.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <set>

namespace {

using namespace crease;

/// Language and stage.
std::string language_of(const pass& p) {
    return std::string(host_begins(p)) + std::to_string(static_cast<int>(p.dialect)) +
           std::to_string(static_cast<int>(stage_of_whole(p)));
}

/// Checks the text of the different programs of all legal compositions, of which many share passes to the
/// letter, and compiles one of `shares` parts of those that hold a definition that is new, with what it
/// depends on, and of some of the others, as what is bound depends on the whole program.
void check_share(std::size_t share, std::size_t shares) {
    std::set<std::string> seen, without_use;
    seen_definitions definitions;
    std::size_t effects = 0, to_compile = 0, compiled = 0;
    for (const std::string& text : every_recipe()) {
        CAPTURE(text);
        const auto composed = std::make_unique<composition>(recipe(std::string_view(text)));
        const effect_view effect = composed->view();
        for (const pass& p : effect.passes) {
            if (!seen.insert(without_recipe(text_of(p))).second)
                continue;
            CAPTURE(std::string(p.name));
            const std::vector<piece> whole = whole_program(p);
            const joined_pieces joined(whole);
            CHECK(names_before_declaration(joined) == std::vector<std::string>{});
            if (seen.size() % shares == share)
                collect_unused(p, without_use);
            if (!definitions.add(language_of(p), joined) && seen.size() % 40 != 0)
                continue;
            if (to_compile++ % shares == share) {
                ++compiled;
                CHECK_NOTHROW(check_program(effect, p));
            }
        }
        ++effects;
    }
    MESSAGE(effects << " effects of " << seen.size() << " different programs; " << to_compile
                    << " hold all of their definitions, of which " << compiled << " are compiled here");
    for (const std::string& each : without_use)
        MESSAGE("no use: " << each);
    CHECK(without_use.empty());
    CHECK(effects > 1000);
    CHECK(compiled > 1000);
}

}

TEST_CASE("legal compositions 1 of 2") {
    check_share(0, 2);
}
TEST_CASE("legal compositions 2 of 2") {
    check_share(1, 2);
}

TEST_CASE("optimised modules stay valid and keep their constants") {
    const recipe chosen("directions:8x4/single_layer/hbao/bilateral/upsample:2");
    const auto composed = std::make_unique<composition>(chosen);
    for (const pass& p : composed->view().passes)
        for (spirv::goal aim : {spirv::goal::speed, spirv::goal::size}) {
            const spirv::words module = spirv::optimise(spirv::compile(p), aim);
            spirv::validate(module);
            CHECK(spirv::reflect(module).constants.size() == p.constants.size());
        }
}

TEST_CASE("what nothing uses is found") {
    CHECK(identifiers_without_use(
              "const int crease_a = 1; // crease_a\nint crease_b() { return 2; }\nvoid main() { "
              "crease_b(); }\n") == std::vector<std::string>{"crease_a"});
    CHECK(identifiers_without_use("layout(std140) uniform crease_parameters { float x; } crease_given;\n"
                                  "float crease_x = crease_given.x;\n"
                                  "buffer crease_n_buffer { uint crease_n[]; };\n") ==
          std::vector<std::string>{"crease_n", "crease_x"});
    const piece text[] = {{"interface", "#define crease_write crease_encode()\n"},
                          {"a", "float crease_one() { return 1.0; }\n"},
                          {"a", "float crease_two() { return crease_one(); }\n"},
                          {"a", "float crease_three() { return crease_four(); }\n"},
                          {"a", "float crease_four() { return 4.0; }\n"},
                          {"a", "float crease_encode() { return 5.0; }\n"},
                          {"a", "void main() { crease_two(); crease_write }\n"}};
    std::vector<std::string> found = definitions_without_caller(text);
    std::ranges::sort(found);
    CHECK(found == std::vector<std::string>{"float crease_four() { return 4.0; }\n",
                                            "float crease_three() { return crease_four(); }\n"});
}
