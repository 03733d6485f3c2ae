// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace crease::tools {

/// Checks a name that a host chooses for a header, its namespace and its manifest: an identifier of C++ that
/// is neither a word of the language, nor reserved, nor another's.
/// @throws recipe_error  with one sentence that says why not
void expect_name(std::string_view name);

}
