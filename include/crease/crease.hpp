// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect.hpp>
#include <crease/parts.hpp>
#include <crease/recipe.hpp>
