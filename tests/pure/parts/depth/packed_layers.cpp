// SPDX-License-Identifier: MIT
#include <crease/parts/depth/packed_layers.hpp>

#include <crease/parts/depth/stochastic_layers.hpp>

#include <doctest/doctest.h>

namespace {

using namespace crease;

resource shaped(int count, unsigned views) {
    const choice own{&stochastic_layers_part::description, {count}};
    resource r = packed_layers;
    r.shape(r, {{}, own, views});
    return r;
}

}

TEST_CASE("groups of four layers, of each camera in a row; one or two layers need as many components") {
    CHECK(shaped(1, 1).texels == format::r32_float);
    CHECK(shaped(2, 1).texels == format::rg32_float);
    for (int count : {3, 4, 5, 8, 9, 32}) {
        CAPTURE(count);
        CHECK(shaped(count, 1).texels == format::rgba32_float);
        CHECK(shaped(count, 1).layers == (static_cast<unsigned>(count) + 3) / 4);
        CHECK(shaped(count, 2).layers == 2 * shaped(count, 1).layers);
    }
    CHECK(packed_layers.size.guarded);
}
