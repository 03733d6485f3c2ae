// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

namespace {

using namespace crease;

format shaped(array_view<const choice> parts) {
    resource image = visibility_image;
    shape_visibility(image, {parts, parts[0], 1});
    return image.texels;
}

}

TEST_CASE("visibility has the format that the part of the role offers, and one byte otherwise") {
    const choice one[] = {choice_of<r8>()}, four[] = {choice_of<rgba8>()}, real[] = {choice_of<r32f>()};
    CHECK(shaped(one) == format::r8_unorm);
    CHECK(shaped(four) == format::rgba8_unorm);
    CHECK(shaped(real) == format::r32_float);
}
