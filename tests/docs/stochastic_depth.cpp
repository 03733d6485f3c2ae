// SPDX-License-Identifier: MIT
// The C++ of the page of layers does what the page says.
#include "step.hpp"

#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <string_view>
#include <vector>

#include "stochastic_depth.inc"

TEST_CASE("the page's geometry pass captures layers, and the cone comes out") {
    CHECK(stochastic_depth_page::capture.name == "capture_layers");
    CHECK(stochastic_depth_page::capture_text.find("void crease_capture(vec3 anchor)") !=
          std::string_view::npos);
    if (!step::device().features().cover(stochastic_depth_page::layered::features)) {
        MESSAGE("the device lacks depth images of 8 samples: layers are not drawn on it");
        return;
    }
    const std::vector<float> cones = step::run(stochastic_depth_page::layered::view(), "bent_cone");
    CHECK(cones.size() == step::width * step::height * 4);
}
