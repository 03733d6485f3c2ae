// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using centred = effect<directions<4, 4>, stochastic_layers<6>, hbao, centred_samples<>>;
static_assert(centred::features.depth_samples == 8 && centred::features.centred_depth_samples == 8);
static_assert(!contains(centred::source<0>, "gl_FragDepth"));

}

TEST_CASE("the captured layers, and no other image, have all samples of a texel at its centre") {
    for (const resource& r : centred::resources)
        CHECK(r.centred == (r.name == "captured_layers"));
    CHECK(centred::passes[0].to_attachment());
}
