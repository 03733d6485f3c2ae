// SPDX-License-Identifier: MIT
#pragma once

#include "arena.hpp"

#include <crease_c.h>

#include <crease/compose/recipe.hpp>
#include <crease/effect/effect_view.hpp>

namespace crease::c {

/// An effect as C has it, with copies of all its text.
const crease_effect* described(arena& memory, const effect_view& effect, const recipe& chosen);

}
