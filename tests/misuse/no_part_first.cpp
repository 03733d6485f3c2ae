// crease::effect: a template argument is not a part: it has no `description` of type crease::part
// (settings)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

struct settings {
    int description = 0;
};

using namespace crease;

constexpr auto count = effect<settings, single_layer, hbao>::passes.size();
