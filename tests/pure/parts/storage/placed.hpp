// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/pass.hpp>

#include <doctest/doctest.h>

/// Whether set 1, bindings from 20 and constants from 30 on are those of what the host's shader binds.
/// @param own  a pass of the effect's own, which is not placed
inline void check_placed(const crease::pass& captures, const crease::pass& own) {
    for (const crease::binding& b : captures.bindings)
        if (has_descriptor(b.how)) {
            CHECK(b.set == 1);
            CHECK(b.slot >= 20);
        }
    for (const crease::constant& c : captures.constants)
        CHECK(c.id >= 30);
    for (const crease::binding& b : own.bindings)
        CHECK(b.set == 0);
}
