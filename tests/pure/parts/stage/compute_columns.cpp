// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;

using in_columns = effect<directions<4, 4>, single_layer, hbao, bilateral<>, compute_columns<8, 4, 6>>;
using in_rows = effect<directions<4, 4>, single_layer, hbao, bilateral<>>;
static_assert(stage_of(compute_columns_part::description) == stage_kind::compute);
static_assert(in_columns::passes[0].group_width() == 8 && in_columns::passes[0].group_height() == 4);
static_assert(!recipe("directions/single_layer/hbao/compute_columns:8x8x0"));
static_assert(!recipe("directions/single_layer/hbao/compute_columns/compute"));

}

TEST_CASE("compute_columns runs workgroups in columns of so many, and compute as they come") {
    CHECK(contains(in_columns::source<0>(), "const int crease_compute_columns_across = 6;"));
    CHECK(contains(in_columns::source<0>(), "uvec2 crease_workgroup()"));
    CHECK(!contains(in_columns::source<1>(), "uvec2 crease_workgroup()")); // a filter reads near its pixel
    CHECK_FALSE(contains(in_rows::source<0>(), "crease_workgroup"));
}
