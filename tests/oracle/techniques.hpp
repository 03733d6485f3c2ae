// SPDX-License-Identifier: MIT
#pragma once

#include "effect.hpp"

#include <functional>
#include <string>
#include <vector>

namespace oracle {

using occlusion_of = std::function<double(const picture& p, const receiver& r, const settings& s)>;

/// A sampler with an estimator, as a recipe's words and as the oracle's functions.
struct technique {
    std::string sampler, estimator;
    occlusion_of occlusion;

    /// The recipe on one layer of depth.
    std::string recipe() const { return sampler + "/single_layer/" + estimator; }
};

/// Each estimator of taps and layers, each sampler that it takes.
const std::vector<technique>& techniques();

}
