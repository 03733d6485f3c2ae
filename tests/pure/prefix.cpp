// SPDX-License-Identifier: MIT
#include <crease/prefix.hpp>

#include <doctest/doctest.h>

using namespace crease;

static_assert(prefix_error("near_").empty() && prefix_error("_a1").empty());
static_assert(!prefix_error("").empty() && !prefix_error("1a").empty() && !prefix_error("a-b").empty());
static_assert(!prefix_error("gl_a").empty() && !prefix_error("a__b").empty());

TEST_CASE("a prefix takes the place of crease_ where a name begins, and nowhere else") {
    constexpr piece pieces[] = {{"a", "crease_a(crease_b, my_crease_c) crease_crease_d"},
                                {"b", "crease_e;\nfloat creased = crease_f.crease;\n"}};
    CHECK(with_prefix(pieces, "near_") == "near_a(near_b, my_crease_c) near_crease_dnear_e;\n"
                                          "float creased = near_f.crease;\n");
    CHECK(with_prefix({}, "near_").empty());
}
