// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>
#include <crease/vulkan/runner.hpp>

#include "little_effect.hpp"
#include "sentence.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("a pass may not run at another size than that of what it writes, in either axis") {
    const auto said = [](std::size_t which, const extent& size) {
        pass passes[] = {little::scale, little::spread};
        passes[which].size = size;
        effect_view effect = little::effect;
        effect.passes = passes;
        return sentence_of([&] { vulkan::runner(validated_device(), effect, 8, 8); });
    };
    const std::string of_compute = "pass 'scale' runs at another size than that of 'scaled', which it writes";
    CHECK(said(0, {.divisor = 2}) == ""); // as it is declared
    CHECK(said(0, {.divisor = 4}) == ""); // the rest is not written
    CHECK(said(0, {.divisor = 2, .fixed_width = 5}) == of_compute);
    CHECK(said(0, {.divisor = 2, .fixed_height = 5}) == of_compute);
    const std::string of_fragment =
        "pass 'spread' runs at another size than that of 'visibility', which it writes";
    CHECK(said(1, {.fixed_width = 7}) == of_fragment);
    CHECK(said(1, {.fixed_height = 7}) == of_fragment);
    CHECK(said(1, {.fixed_height = 9}) == of_fragment);
}
