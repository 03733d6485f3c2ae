// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

namespace {

using namespace crease;

static_assert(stage_of(compute_part::description) == stage_kind::compute);
static_assert(stage_of(fragment::description) == stage_kind::fragment);
static_assert(stage_of(functions_part::description) == stage_kind::functions);
static_assert(has(opengl_glsl::description.offers, &opengl_words::value));
static_assert(!has(vulkan_glsl::description.offers, &opengl_words::value));

}

TEST_CASE("the stage is of the passes that hand a result on; what fills tables is always compute") {
    using tables = effect<sample_box, summed_area<>, mean_height<>, fragment>;
    for (std::size_t i = 0; i < tables::passes.size(); ++i)
        CHECK(tables::passes[i].stage ==
              (i + 1 < tables::passes.size() ? stage_kind::compute : stage_kind::fragment));
}
