// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using layered = effect<directions<4, 4>, stochastic_layers<6>, hbao, atomic_minimum<1, 2, 3>, simple_hash>;
static_assert(!layered::passes[0].to_attachment());
static_assert(layered::features.fragment_stores_and_atomics && layered::features.depth_samples == 0);
static_assert(contains(layered::passes[0].pieces[0].text,
                       "layout(constant_id = 3) const int crease_stochastic_layers_count = 6;"));
static_assert(contains(layered::passes[0].pieces[0].text, "set = 1, binding = 2"));
static_assert(!effect<directions<4, 4>, stochastic_layers<6>, hbao, atomic_minimum<1, 2, 3>,
                      opengl_glsl>::features.fragment_stores_and_atomics); // OpenGL asks for no feature

}

TEST_CASE("atomic_minimum's image has a layer for each that the depth source keeps, and is cleared") {
    bool is_there = false;
    for (const resource& r : layered::resources)
        if (r.name == "captured_layers") {
            is_there = true;
            CHECK(r.layers == 6);
            CHECK(r.arrayed);
            CHECK(r.cleared);
            CHECK(r.clear == ~0u);
            CHECK(r.life == lifetime::transient);
        }
    CHECK(is_there);
    CHECK(layered::passes[0].bindings.back().how == access::modify);
    CHECK(contains(layered::source<0>, "imageAtomicMin(crease_captured_layers"));
}
