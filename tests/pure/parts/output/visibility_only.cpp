// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using by_default = effect<directions<4, 4>, single_layer, hbao, bilateral<>>;
static_assert(visibility_only::description.needs.empty());
static_assert(by_default::features.extended_storage_formats); // r8

}

TEST_CASE("visibility_only is the default: one image, and between passes a depth beside it") {
    unsigned outputs = 0;
    for (const resource& r : by_default::resources)
        outputs += r.life == lifetime::output;
    CHECK(outputs == 1);
    CHECK(by_default::resources.back().name == "visibility");
    CHECK(contains(by_default::source<0>(), "result.visibility * 255.0 + 0.5")); // the low byte of the depth
    CHECK(contains(by_default::source<2>(),
                   "imageStore(crease_output, pixel, crease_encode_visibility(result));"));
    CHECK(contains(by_default::source<0>(),
                   "crease_result(1.0, crease_background, vec3(0.0, 0.0, 1.0))")); // background is open
}
