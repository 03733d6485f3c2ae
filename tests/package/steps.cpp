// SPDX-License-Identifier: MIT
// Effects of every kind, for a compiler that is allowed few steps of constant evaluation.
#include <crease/crease.hpp>

using namespace crease;

template <class Effect, std::size_t... Pass>
constexpr std::size_t length(std::index_sequence<Pass...>) {
    return (joining::size_of(Effect::passes[Pass].pieces) + ...);
}

template <class... Parts>
constexpr std::size_t
    length_of = length<effect<Parts...>>(std::make_index_sequence<effect<Parts...>::passes.size()>{});

static_assert(length_of<directions<>, single_layer, hbao> > 1000);
static_assert(length_of<directions<64, 64>, single_layer, hbao_plus, fragment> > 1000);
static_assert(length_of<poisson_disk<64>, single_layer, hbao_plus, orthographic, opengl_glsl> > 1000);
static_assert(length_of<hemisphere_points<>, single_layer, ssao, linear_depth, reconstructed_normals> > 1000);
static_assert(length_of<directions<>, single_layer, hbao, functions<31, 1023, 1023>> > 1000);
static_assert(length_of<directions<>, single_layer, hbao, bilateral<>, upsample<>, bilateral<>> > 1000);
static_assert(length_of<directions<>, single_layer, hbao, bilateral<>, bilateral<>, bilateral<>, bilateral<>,
                        orthographic, linear_depth, reconstructed_normals, fragment, opengl_glsl> > 1000);
static_assert(recipe("directions:8x4/single_layer/hbao/bilateral/upsample/fragment/opengl"));
