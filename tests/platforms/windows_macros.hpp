// SPDX-License-Identifier: MIT
#pragma once

// The lower-case words that <windows.h> defines. Standard headers come before them, as libstdc++ takes `min`
// and `max` back.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>

#define cdecl
#define far
#define hyper long long
#define interface struct
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define near
#define pascal
#define small char
