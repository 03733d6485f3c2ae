// crease::effect: the receivers are layers, and the depth source keeps no normals of them
// (every_layer, opacities)
// no recipe says this
// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

using namespace crease;

struct opacities {
    static constexpr part description{
        .kind = role::depth_source,
        .name = "opacities",
        .summary = "layers of depth and opacity",
        .source = "the engine",
        .offers = traits<depth_layers, layers_with_opacity>::list,
    };
};

constexpr auto count = effect<directions<>, opacities, hbao, every_layer>::passes.size();
