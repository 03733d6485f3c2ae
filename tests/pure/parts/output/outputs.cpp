// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace crease;

static_assert(visibility_image.texels == format::r8_unorm && visibility_image.life == lifetime::output);
static_assert(between_image(format::r32_uint).life == lifetime::handed_on);

}

TEST_CASE("every output leaves images of its own, and hands one on to filters") {
    for (const part* p : all_parts) {
        if (p->kind != role::output)
            continue;
        CAPTURE(p->name);
        unsigned outputs = 0, handed_on = 0;
        for (const resource& r : p->resources) {
            outputs += r.life == lifetime::output;
            handed_on += r.life == lifetime::handed_on;
        }
        CHECK(outputs >= 1);
        CHECK(handed_on == 1);
    }
}

TEST_CASE("what one pass hands on is an image of its own, as large as what the pass makes") {
    using filtered = effect<directions<4, 4>, single_layer, hbao, upsample<2>>;
    CHECK(filtered::resources.back().name == "visibility");
    CHECK(filtered::resources.back().size.divisor == 1);
    const auto r = std::ranges::find(filtered::resources, "between_0", &resource::name);
    REQUIRE(r != filtered::resources.end());
    CHECK(r->life == lifetime::transient);
    CHECK(r->texels == format::rg32_uint);
    CHECK(r->size.divisor == 2);
}
