// SPDX-License-Identifier: MIT
// Effects of fragment shaders as GLSL ES 3.00: every legal composition that has no pass of another kind.
#include "pure/compositions.hpp"
#include "text/host_program.hpp"

#include <crease/spirv.hpp>

#include <doctest/doctest.h>

#include <memory>
#include <set>
#include <string>

namespace {

using namespace crease;

bool names_any_of(const recipe& chosen, std::initializer_list<role> roles) {
    for (const choice& c : chosen.choices())
        for (const role each : roles)
            if (c.what->kind == each)
                return true;
    return false;
}

}

TEST_CASE("every fragment effect without other passes compiles as GLSL ES 3.00") {
    std::set<std::string> seen, without_use;
    std::size_t effects = 0, refused = 0, candidates = 0;
    for (const std::string& text : every_recipe()) {
        if (names_any_of(recipe(std::string_view(text)), {role::stage, role::dialect}))
            continue;
        for (const char* stage : {"/fragment", "/functions"}) {
            if (stage[2] == 'u' && ++candidates % 8 != 0) // as their programs differ in the root alone
                continue;
            const std::string es = text + stage + "/glsl_es:300";
            CAPTURE(es);
            const recipe chosen{std::string_view(es)};
            if (!chosen) {
                ++refused;
                CHECK(std::string(chosen.error()).find("GLSL ES") != std::string::npos);
                continue;
            }
            ++effects;
            const auto composed = std::make_unique<composition>(chosen);
            REQUIRE(*composed);
            for (const pass& p : composed->view().passes) {
                if (!seen.insert(without_recipe(text_of(p))).second)
                    continue;
                CAPTURE(std::string(p.name));
                CHECK_NOTHROW(check_program(composed->view(), p));
                collect_unused(p, without_use);
                CHECK(text_of(p).find("binding = ") == std::string::npos);
            }
        }
    }
    for (const std::string& each : without_use)
        MESSAGE("no use: " << each);
    CHECK(without_use.empty());
    CHECK(effects > 500);
    CHECK(refused > 500);
    MESSAGE(effects << " effects of " << seen.size() << " different programs; " << refused << " refused");
}
