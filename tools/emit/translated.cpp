// SPDX-License-Identifier: MIT
#include "translated.hpp"

#include <crease/translate.hpp>

namespace crease::tools {

namespace {

translate::translation checked(translate::translation made, const pass& which) {
    translate::check(made, "pass '" + std::string(which.name) + "' in " + name_of(made.made_for));
    return made;
}

}

translate::translation translated(const effect_view& effect, const pass& which, const translate::target& to) {
    return checked(translate::shader(effect, which, to), which);
}

translate::translation translated_vertex(const effect_view& effect, const pass& which,
                                         const translate::target& to) {
    return checked(translate::vertex_shader(effect, which, to), which);
}

}
