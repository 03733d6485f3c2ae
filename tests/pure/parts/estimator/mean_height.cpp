// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using oriented = effect<sample_box, summed_area<>, mean_height<>>;

static_assert(!recipe("directions/summed_area/mean_height"));
static_assert(!recipe("sample_box/single_layer/mean_height"));
static_assert(!recipe("directions/summed_area/hbao"));

}

TEST_CASE("mean_height recommends its settings, and folds layers by their mean") {
    for (const setting& each : mean_height<>::reads)
        CHECK(oriented::defaults.*each.field == each.fallback);
    CHECK_FALSE(piece_of(oriented::passes.back(), "core/fold_mean.glsl").empty());
    CHECK(contains(oriented::source<4>, "const int crease_mean_height_oriented = 1;"));
}
