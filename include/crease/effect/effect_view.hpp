// SPDX-License-Identifier: MIT
#pragma once

#include <crease/effect/device_features.hpp>
#include <crease/effect/parameters.hpp>
#include <crease/effect/pass.hpp>
#include <crease/effect/resource.hpp>

namespace crease {

/// An effect as data, whether it was composed at compile time or at run time: all a renderer needs to run it.
/// It views static storage, or that of the `composition` that it came from.
struct effect_view {
    array_view<const pass> passes;        ///< in the order of execution, geometry passes among them
    array_view<const resource> resources; ///< resource 0 is the block of parameters; the outputs come last
    array_view<const effect_setting> settings; ///< in the order of the block of parameters
    unsigned views = 1;                        ///< cameras, that of the picture included
    device_features features;                  ///< that the device must have
    parameters defaults;       ///< the settings as the parts recommend them; no view in it yet
    std::string_view recipe{}; ///< what it was composed of, with all numbers: with the version of crease it
                               ///< says each word of the text

    /// Bytes of the block of parameters.
    constexpr std::size_t block_size() const { return crease::block_size(views, settings.size()); }
};

}
