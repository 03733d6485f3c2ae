// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/effect_view.hpp>
#include <crease/translate/translation.hpp>

namespace crease::tools {

/// The shader of a pass in another language, and of a fragment pass its vertex shader; checked.
/// @throws std::runtime_error  with a sentence, also where crease was built without crease::translate
translate::translation translated(const effect_view& effect, const pass& which, const translate::target& to);
translate::translation translated_vertex(const effect_view& effect, const pass& which,
                                         const translate::target& to);

}
