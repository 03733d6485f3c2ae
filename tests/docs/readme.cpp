// SPDX-License-Identifier: MIT
// The C++ of the README does what the README says.
#include "step.hpp"

#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "readme.inc"

TEST_CASE("the README's effect runs with the README's parameters") {
    const crease::parameters p = readme_page::parameters_of(step::perspective, step::width, step::height, 7);
    CHECK(p.view == step::parameters_for(readme_page::ao::view(), false).view);
    CHECK(crease::get(p, readme_page::settings, "strength") == 1.2f);
    CHECK(p.frame == 7);
    CHECK(readme_page::ao::block(p).size() == readme_page::ao::view().block_size());
    CHECK(step::joined(readme_page::passes[0].pieces) == readme_page::first);
    CHECK(readme_page::first.data()[readme_page::first.size()] == '\0');
    CHECK(step::device().features().cover(readme_page::features));
    const std::vector<float> visibility = step::run(readme_page::ao::view(), "visibility");
    CHECK(std::ranges::min(visibility) < 0.95f);
    CHECK(std::ranges::max(visibility) > 0.95f);
    CHECK(readme_page::resources.back().name == "visibility");
}

TEST_CASE("the README's composition is the README's effect, and a bad recipe throws its sentence") {
    const auto composed = readme_page::compose("preset:medium");
    CHECK(step::joined(composed->view().passes[0].pieces) == readme_page::first);
    CHECK_THROWS_WITH(readme_page::compose("directions/hbao"),
                      "crease::effect: the second part must be a depth source (hbao)");
}
