// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace crease::tools {

/// What a candidate was found to cost and to err.
struct trial {
    std::string candidate;   ///< RECIPE[@name=value,...]
    double error = 0;        ///< RMSE over the views of the search, their mean
    double milliseconds = 0; ///< of all passes on the first view, geometry passes among them; a warm median
    double instructions = 0; ///< a pixel of the picture, of all passes but those of geometry; infinite where
                             ///< a loop has no constant count
    double fetches = 0;      ///< likewise
    std::string refused;     ///< why it could not be run, and the figures are nothing; else empty
};

/// A search as its file keeps it: whole after each trial, so that it goes on where it was interrupted.
struct search_state {
    nlohmann::ordered_json setup; ///< what the figures follow from
    std::vector<trial> trials;
};

/// Reads the state of a search; an empty one where there is no file.
/// @throws file_error, std::runtime_error  where it is no such state, or that of another set-up
search_state read_state(const std::filesystem::path& file, const nlohmann::ordered_json& setup);

/// Writes it, whole or not at all.
/// @throws file_error
void write_state(const std::filesystem::path& file, const search_state& state);

/// A trial as JSON.
nlohmann::ordered_json described(const trial& of);

}
