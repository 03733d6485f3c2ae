// SPDX-License-Identifier: MIT
// Effects with a host's own part of each role compile, and have the interface that they declare.
#include "pure/own_parts.hpp"
#include "text/host_program.hpp"

#include <doctest/doctest.h>

TEST_CASE("effects with a host's own part of each role compile as they are declared") {
    std::set<std::string> without_use;
    own::for_each_example([&without_use](const auto& each) {
        const crease::effect_view effect = std::decay_t<decltype(each)>::effect_type::view();
        CAPTURE(std::string(each.recipe));
        for (const crease::pass& p : effect.passes) {
            CAPTURE(std::string(p.name));
            CHECK_NOTHROW(check_program(effect, p));
            collect_unused(p, without_use);
        }
    });
    for (const std::string& name : without_use)
        MESSAGE("no use: " << name);
    CHECK(without_use.empty());
}
