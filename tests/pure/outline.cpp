// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include "text.hpp"

#include <doctest/doctest.h>

#include <type_traits>

namespace {

using namespace crease;

template <class One, class Other>
constexpr bool share = std::is_same_v<typename One::outline, typename Other::outline>;

template <class... Rest>
using plain = effect<directions<8, 4>, single_layer, hbao, Rest...>;

// Numbers that are no more than constants are left open.
static_assert(share<plain<>, effect<directions<64, 1>, single_layer, hbao>>);
static_assert(share<plain<bilateral<2>>, plain<bilateral<16>>>);
static_assert(share<plain<compute<8, 8>>, plain<compute<32, 4>>>);
static_assert(share<plain<tiled_noise<4>>, plain<tiled_noise<8>>>);

// What decides on passes, resources or places is not.
static_assert(!share<plain<>, effect<directions<8, 4>, single_layer, hbao_plus>>);
static_assert(!share<plain<>, plain<compute<>>>);
static_assert(!share<plain<upsample<2>>, plain<upsample<4>>>);
static_assert(!share<plain<functions<0>>, plain<functions<1>>>);
static_assert(!share<effect<directions<>, stochastic_layers<4>, hbao>,
                     effect<directions<>, stochastic_layers<8>, hbao>>);
static_assert(!share<effect<directions<>, stochastic_layers<4>, hbao_plus, second_view<1>>,
                     effect<directions<>, stochastic_layers<4>, hbao_plus, second_view<2>>>);

// An open number stands for that of its part at its place.
static_assert(!open_number::is(0) && !open_number::is(-1));
static_assert(open_number::is(open_number::of(most_parts - 1, most_numbers - 1)));
static_assert(open_number::value_of(open_number::of(0, 1), plain<>::choices) == 4);
static_assert(open_number::value_of(open_number::of(3, 0), plain<bilateral<7>>::choices) == 7);
static_assert(open_number::value_of(5, plain<>::choices) == 5);

}

TEST_CASE("effects of one outline have numbers of their own") {
    using one = plain<compute<8, 4>, bilateral<2>, bilateral<3>>;
    using other =
        effect<directions<64, 16>, single_layer, hbao, compute<128, 1>, bilateral<16>, bilateral<1>>;
    static_assert(share<one, other>);
    CHECK(one::passes[0].group_width() == 8);
    CHECK(other::passes[0].group_width() == 128);
    CHECK(contains(piece_of(one::passes[0], "interface"), "crease_directions_count = 8;"));
    CHECK(contains(piece_of(other::passes[0], "interface"), "crease_directions_count = 64;"));
    CHECK(contains(piece_of(other::passes[0], "interface"), "local_size_x = 128, local_size_y = 1"));
    for (std::size_t i = 0; i < one::passes.size(); ++i)
        CHECK(one::passes[i].name == other::passes[i].name);
    const std::size_t last = one::passes.size() - 1;
    CHECK(contains(piece_of(one::passes[1], "interface"), "crease_bilateral_radius = 2;"));
    CHECK(contains(piece_of(one::passes[last], "interface"), "crease_bilateral_radius = 3;"));
    CHECK(contains(piece_of(other::passes[1], "interface"), "crease_bilateral_radius = 16;"));
    CHECK(contains(piece_of(other::passes[last], "interface"), "crease_bilateral_radius = 1;"));
    CHECK(one::passes[last].constants.back().value == 3);
    CHECK(other::passes[last].constants.back().value == 1);
}
