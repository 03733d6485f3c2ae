// SPDX-License-Identifier: MIT
#include <crease/vulkan/constant_values.hpp>

#include "little_effect.hpp"
#include "sentence.hpp"

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("constants that are not given keep their defaults, in the order of the pass") {
    const vulkan::detail::constant_values values(little::effect, {{"compute.height", 3}});
    CHECK(values.of(little::scale) == std::vector<std::int32_t>{8, 3, 2});
    CHECK(values.of(little::spread).empty());
}

TEST_CASE("a constant that the effect has not is refused by its name") {
    CHECK(sentence_of([] {
              vulkan::detail::constant_values(little::effect, {{"scale.loss", 1}});
          }) == "the effect has no constant 'scale.loss'; it has compute.width, compute.height, scale.gain");
}
