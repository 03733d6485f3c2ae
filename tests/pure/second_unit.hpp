// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

/// Where the other translation unit has the index of parts.
const void* parts_of_second_unit();

/// The text that the other translation unit has of `effect<directions<>, single_layer, hbao>`.
std::string_view source_of_second_unit();
