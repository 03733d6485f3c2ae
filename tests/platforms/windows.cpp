// SPDX-License-Identifier: MIT
// The same after the system's own header.
#include <windows.h>

#include "pure.cpp"
