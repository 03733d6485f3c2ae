// SPDX-License-Identifier: MIT
#pragma once

// The presets, from the least time to the least error; docs/benchmarks.md measures them.
//
// To add one: a struct here with its `parts` and its `description`, and a line in the index below. A preset
// of a host's own is the same struct in its own file.

#include <crease/compose/preset.hpp>
#include <crease/parts/all_parts.hpp>

/// Parts that go well together, for `effect` and, as preset:NAME, for recipes.
///
/// All aim at the linear truth, in which what is near hides more; with `cosine_bitmask<>` behind a preset it
/// aims at the hard one, in which all within the radius hides alike.
namespace crease::preset {

/// Half resolution, about 8 fetches a pixel of the half: the least time.
struct low {
    using parts = part_list<half_directions<1, 6>, single_layer, cosine_bitmask<1>,
                            interleaved_gradient_noise, separable_plane_filter<2>, upsample<2>>;
    static constexpr preset_description description{"low", "half resolution: the least time",
                                                    choices_in<parts>};
};

/// About 10 fetches a pixel: what most pictures want.
struct medium {
    using parts = part_list<half_directions<1, 8>, single_layer, cosine_bitmask<1>,
                            interleaved_gradient_noise, separable_plane_filter<2>>;
    static constexpr preset_description description{
        "medium", "one direction of 8 taps: what most pictures want", choices_in<parts>};
};

/// About 18 fetches a pixel.
struct high {
    using parts = part_list<half_directions<2, 8>, single_layer, cosine_bitmask<1>,
                            interleaved_gradient_noise, separable_plane_filter<2>>;
    static constexpr preset_description description{"high", "two directions of 8 taps", choices_in<parts>};
};

/// About 32 fetches a pixel: what one layer of depth can say.
struct ultra {
    using parts = part_list<half_directions<3, 10>, single_layer, cosine_bitmask<1>,
                            interleaved_gradient_noise, separable_plane_filter<2>>;
    static constexpr preset_description description{
        "ultra", "three directions of 10 taps: what one layer of depth can say", choices_in<parts>};
};

/// The four nearest layers, exactly, of what the host draws once more: its pass stands in the schedule as
/// "capture_layers". A guard band of 5 to 10 % of the picture's width around it gives the most.
struct ultra_layers {
    using parts = part_list<half_directions<2, 8>, layer_array<4>, cosine_bitmask<1>,
                            interleaved_gradient_noise, separable_plane_filter<2>>;
    static constexpr preset_description description{
        "ultra_layers", "layers behind the first, which a geometry pass of the host captures",
        choices_in<parts>};
};

}

namespace crease {

/// Every preset of crease, for recipes and lists.
inline constexpr const preset_description* all_presets[] = {
    &preset::low::description,   &preset::medium::description,       &preset::high::description,
    &preset::ultra::description, &preset::ultra_layers::description,
};

}
