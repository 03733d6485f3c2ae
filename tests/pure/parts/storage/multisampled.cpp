// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using sampled = effect<directions<4, 4>, stochastic_layers<6>, hbao>;
static_assert(sampled::passes[0].to_attachment());
static_assert(sampled::features.depth_samples == 8); // the next power of two
static_assert(effect<directions<4, 4>, stochastic_layers<8>, hbao>::features.depth_samples == 8);
static_assert(sampled::features.centred_depth_samples == 0);
static_assert(!sampled::features.fragment_stores_and_atomics);
static_assert(contains(sampled::source<0>, "gl_FragDepth"));

}

TEST_CASE("multisampled's image has a sample for each layer that the depth source keeps") {
    bool is_there = false;
    for (const resource& r : sampled::resources)
        if (r.name == "captured_layers") {
            is_there = true;
            CHECK(r.samples == 8);
            CHECK(r.texels == format::d32_float);
            CHECK_FALSE(r.centred);
        }
    CHECK(is_there);
    const auto& bindings = sampled::passes[0].bindings;
    CHECK(bindings.back().how == access::attachment);
    CHECK(contains(sampled::source<1>, "uniform sampler2DMS crease_captured_layers;\n"));
}
