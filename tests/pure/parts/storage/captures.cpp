// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

namespace {

using namespace crease;

/// What a shape makes of a depth source that keeps so many samples.
resource shaped(void (*shape)(resource&, const shape_of&), int count) {
    const choice source{&stochastic_layers_part::description, {count}};
    const choice parts[] = {source};
    resource made;
    shape(made, {parts, source, 1});
    return made;
}

}

TEST_CASE("samples are a power of 2, at least 2, and as many as the layers") {
    constexpr unsigned expected[][2] = {{1, 2}, {2, 2}, {3, 4}, {4, 4}, {5, 8}, {8, 8}, {9, 16}, {32, 32}};
    for (const auto& each : expected) {
        const unsigned count = each[0], samples = each[1];
        CAPTURE(count);
        CHECK(shaped(&shape_samples, static_cast<int>(count)).samples == samples);
        CHECK(shaped(&shape_layers, static_cast<int>(count)).layers == count);
    }
}

TEST_CASE("what the cameras beside the picture's capture has names of its own") {
    CHECK(std::size(further_captured_layers) == most_further_views);
    CHECK(further_captured_layers[0] == "captured_layers_1");
    using two = effect<directions<4, 4>, stochastic_layers<4>, hbao_plus, second_view<4>, atomic_minimum<>>;
    CHECK(two::passes[0].name == "capture_layers");
    CHECK(two::passes[1].name == "captured_layers_1");
    CHECK(two::passes[1].view == 1);
    CHECK(two::passes[1].size.divisor == 4);
}
