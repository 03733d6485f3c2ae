// SPDX-License-Identifier: MIT
#pragma once

#include "frame/frame.hpp"
#include "measure/work.hpp"

#include <map>
#include <string>
#include <vector>

namespace crease::tools {

/// A recipe, and settings of its own behind it: RECIPE[@name=value,...].
struct candidate {
    std::string text;
    recipe chosen;
    std::map<std::string, float> settings;

    frame_options options_for(const camera& from) const {
        return {.radius = from.ao_radius, .settings = settings};
    }
};

/// @param settings  name=value, for whatever the text does not set itself
/// @throws recipe_error
candidate parse_candidate(const std::string& whole, const std::vector<std::string>& settings = {});

/// The work of a pass.
struct pass_work {
    std::string name;
    shader_work of_pixel; ///< of its output
    double share = 1;     ///< of the picture's texels that its output has
};

/// The work of the passes that a device runs for a recipe, without geometry passes.
std::vector<pass_work> work_of(const recipe& run);

}
