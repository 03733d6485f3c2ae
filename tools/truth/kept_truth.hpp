// SPDX-License-Identifier: MIT
#pragma once

#include "truth/truth.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace crease::tools {

/// The truth of a view: out of a directory that keeps it between runs, else traced and kept there. It is
/// found by what it follows from: the triangles, the camera and the settings, bit for bit, and the version of
/// the tracer.
/// @param label  what people call the view
/// @param say    receives a sentence where what is kept is broken, or is of another scene, camera or settings
/// @throws as trace_truth does; file_error where it cannot be kept
truth kept_truth(const std::filesystem::path& directory, const std::string& label, const mesh& scene,
                 const camera& from, const truth_settings& settings,
                 const std::function<void(const std::string&)>& say);

}
