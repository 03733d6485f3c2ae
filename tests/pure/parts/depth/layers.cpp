// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

TEST_CASE("every depth source holds single layers or means over areas, and not both") {
    using namespace crease;
    for (const part* p : all_parts) {
        if (p->kind != role::depth_source)
            continue;
        CAPTURE(p->name);
        CHECK(has(p->offers, &depth_layers::value) != has(p->offers, &layers_of_areas::value));
        if (has(p->offers, &layers_behind_front::value) || has(p->offers, &layers_of_two_views::value))
            CHECK(has(p->offers, &depth_layers::value));
    }
}
