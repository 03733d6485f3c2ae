// SPDX-License-Identifier: MIT
#include <crease/effect/version.hpp>

#include <doctest/doctest.h>

TEST_CASE("the version is that of the package") {
    CHECK(crease::version == CREASE_VERSION);
}
