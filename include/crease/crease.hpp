// SPDX-License-Identifier: MIT
#pragma once

#include <crease/compose/composition.hpp>
#include <crease/compose/effect.hpp>
#include <crease/parts/all_parts.hpp>
