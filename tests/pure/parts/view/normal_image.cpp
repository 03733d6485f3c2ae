// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

TEST_CASE("an image of normals covers the guard band and says what it holds") {
    constexpr crease::resource image = crease::normal_image("view_normals", crease::format::rgba16_float);
    static_assert(image.name == "normal" && image.content == "view_normals" && image.size.guarded);
    CHECK(image.life == crease::lifetime::input);
}
