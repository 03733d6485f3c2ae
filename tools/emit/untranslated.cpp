// SPDX-License-Identifier: MIT
// In place of translated.cpp where crease is built without crease::translate.
#include "translated.hpp"

#include <stdexcept>

namespace crease::tools {

translate::translation translated(const effect_view&, const pass&, const translate::target& to) {
    throw std::runtime_error("crease was built without SPIRV-Cross, which makes " +
                             std::string(translate::name_of(to.to)) +
                             ": build it with CREASE_TRANSLATE, or take --target spirv");
}

translate::translation translated_vertex(const effect_view& effect, const pass& which,
                                         const translate::target& to) {
    return translated(effect, which, to);
}

}
