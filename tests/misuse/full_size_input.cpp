// crease::effect: a filter takes a picture of full size, and the one before it makes a smaller one
// (history)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

// A filter that reads pixels of the picture, like a temporal one.
struct history {
    static constexpr crease::step passes[] = {
        {.name = "history", .files = crease::bilateral_part::files, .full_size_input = true}};
    static constexpr crease::part description{
        .kind = crease::role::filter, .name = "history", .summary = "", .source = "", .steps = passes};
};

using namespace crease;

constexpr auto count = effect<directions<>, single_layer, hbao, history, upsample<>>::passes.size();
