// SPDX-License-Identifier: MIT
#pragma once

#include <crease/capture/multisampled.hpp>
#include <crease/capture/stratified.hpp>
#include <crease/dialect/vulkan.hpp>
#include <crease/fold/all_layers.hpp>
#include <crease/noise/hashed_noise.hpp>
#include <crease/output/visibility_only.hpp>
#include <crease/scan/work_efficient_scan.hpp>
#include <crease/stage/compute.hpp>
#include <crease/view/device_depth.hpp>
#include <crease/view/given_normals.hpp>
#include <crease/view/perspective.hpp>

namespace crease {

/// The parts of an effect that need not be named.
inline constexpr choice default_choices[] = {
    choice_of<perspective>(),  choice_of<device_depth>(),        choice_of<given_normals>(),
    choice_of<hashed_noise>(), choice_of<multisampled<>>(),      choice_of<stratified>(),
    choice_of<all_layers>(),   choice_of<work_efficient_scan>(), choice_of<visibility_only>(),
    choice_of<compute<>>(),    choice_of<vulkan_glsl>()};

}
