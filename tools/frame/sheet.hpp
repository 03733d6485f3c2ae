// SPDX-License-Identifier: MIT
#pragma once

#include "image/image.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace crease::tools {

/// A picture of a contact sheet and the lines of text under it.
struct sheet_cell {
    const image& picture; ///< grey, 1 channel, values in [0, 1]
    std::vector<std::string> lines;
};

/// Draws cells of one size row by row, and writes the sheet as a PNG.
/// @param columns > 0
/// @throws std::runtime_error  where it cannot be drawn or written
void write_sheet(const std::filesystem::path& path, const std::vector<sheet_cell>& cells, unsigned columns);

}
