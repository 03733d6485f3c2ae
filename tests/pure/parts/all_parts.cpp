// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

using namespace crease;

TEST_CASE("each part stands once in the index, under a name that a recipe can read") {
    std::set<std::string_view> names;
    for (const part* p : all_parts) {
        CAPTURE(p->name);
        CHECK(names.insert(p->name).second);
        CHECK(p->name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789") == std::string_view::npos);
        CHECK_FALSE(p->summary.empty());
    }
}

TEST_CASE("parts of a role stand together in the index, and every role has a part") {
    std::vector<role> roles;
    for (const part* p : all_parts)
        if (roles.empty() || roles.back() != p->kind)
            roles.push_back(p->kind);
    CHECK(roles.size() == role_count);
    std::ranges::sort(roles);
    CHECK(std::ranges::adjacent_find(roles) == roles.end());
}

TEST_CASE("numbers and settings of parts have ranges that hold what they fall back to") {
    for (const part* p : all_parts) {
        CAPTURE(p->name);
        CHECK(p->numbers.size() <= most_numbers);
        for (const number& n : p->numbers) {
            CAPTURE(n.name);
            CHECK(n.least <= n.fallback);
            CHECK(n.fallback <= n.most);
            CHECK_FALSE(n.meaning.empty());
        }
        for (const setting& s : p->settings) {
            CAPTURE(s.name);
            CHECK(s.least <= s.fallback);
            CHECK(s.fallback <= s.most);
            CHECK_FALSE(s.meaning.empty());
        }
    }
}
