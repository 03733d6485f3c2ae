// SPDX-License-Identifier: MIT
#pragma once

#include <crease/parts/coverage/stratified.hpp>
#include <crease/parts/dialect/vulkan.hpp>
#include <crease/parts/noise/hashed_noise.hpp>
#include <crease/parts/output/visibility_only.hpp>
#include <crease/parts/output_format/r8.hpp>
#include <crease/parts/reads/texel_fetch.hpp>
#include <crease/parts/receivers/every_layer.hpp>
#include <crease/parts/receivers/first_surface.hpp>
#include <crease/parts/scan/work_efficient_scan.hpp>
#include <crease/parts/stage/compute.hpp>
#include <crease/parts/storage/multisampled.hpp>
#include <crease/parts/traversal/all_layers.hpp>
#include <crease/parts/traversal/area_layers.hpp>
#include <crease/parts/view/device_depth.hpp>
#include <crease/parts/view/given_normals.hpp>
#include <crease/parts/view/perspective.hpp>

namespace crease {

/// The parts of an effect that need not be named: of each role the first that fits.
inline constexpr choice default_choices[] = {choice_of<perspective>(),
                                             choice_of<device_depth>(),
                                             choice_of<given_normals>(),
                                             choice_of<hashed_noise>(),
                                             choice_of<stratified>(),
                                             choice_of<multisampled<>>(),
                                             choice_of<work_efficient_scan>(),
                                             choice_of<all_layers>(),
                                             choice_of<area_layers>(),
                                             choice_of<first_surface>(),
                                             choice_of<every_layer>(),
                                             choice_of<visibility_only>(),
                                             choice_of<r8>(),
                                             choice_of<texel_fetch>(),
                                             choice_of<compute<>>(),
                                             choice_of<vulkan_glsl>()};

}
