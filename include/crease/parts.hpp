// SPDX-License-Identifier: MIT
#pragma once

// The index of all parts. To add one: its GLSL in templates/crease/<role>/<name>.glsl, its struct in
// include/crease/<role>/<name>.hpp, one include and one line here, and its tests in
// tests/pure/<role>/<name>.cpp.

#include <crease/capture/anisotropic_threshold.hpp>
#include <crease/capture/atomic_minimum.hpp>
#include <crease/capture/centred_samples.hpp>
#include <crease/capture/hash_4d.hpp>
#include <crease/capture/isotropic_threshold.hpp>
#include <crease/capture/multisampled.hpp>
#include <crease/capture/simple_hash.hpp>
#include <crease/capture/stratified.hpp>
#include <crease/depth/mip_chain.hpp>
#include <crease/depth/n_buffer.hpp>
#include <crease/depth/single_layer.hpp>
#include <crease/depth/stochastic_layers.hpp>
#include <crease/depth/summed_area.hpp>
#include <crease/depth/summed_area_adaptive.hpp>
#include <crease/depth/summed_area_uniform.hpp>
#include <crease/dialect/opengl.hpp>
#include <crease/dialect/vulkan.hpp>
#include <crease/estimator/hbao.hpp>
#include <crease/estimator/hbao_plus.hpp>
#include <crease/estimator/line_volume.hpp>
#include <crease/estimator/mean_height.hpp>
#include <crease/estimator/point_volume.hpp>
#include <crease/estimator/ssao.hpp>
#include <crease/estimator/unsharp_mask.hpp>
#include <crease/filter/bilateral.hpp>
#include <crease/filter/upsample.hpp>
#include <crease/fold/all_layers.hpp>
#include <crease/fold/deferred_layers.hpp>
#include <crease/fold/front_first.hpp>
#include <crease/noise/hashed_noise.hpp>
#include <crease/noise/tiled_noise.hpp>
#include <crease/output/bent_cone.hpp>
#include <crease/output/packed_bent_cone.hpp>
#include <crease/output/shade.hpp>
#include <crease/output/visibility_only.hpp>
#include <crease/sampler/box_area.hpp>
#include <crease/sampler/box_window.hpp>
#include <crease/sampler/directions.hpp>
#include <crease/sampler/hemisphere_lines.hpp>
#include <crease/sampler/hemisphere_points.hpp>
#include <crease/sampler/poisson_disk.hpp>
#include <crease/sampler/sample_box.hpp>
#include <crease/sampler/sphere_lines.hpp>
#include <crease/sampler/sphere_points.hpp>
#include <crease/scan/subgroup_scan.hpp>
#include <crease/scan/work_efficient_scan.hpp>
#include <crease/stage/compute.hpp>
#include <crease/stage/fragment.hpp>
#include <crease/stage/functions.hpp>
#include <crease/view/device_depth.hpp>
#include <crease/view/given_normals.hpp>
#include <crease/view/linear_depth.hpp>
#include <crease/view/linearised_depth.hpp>
#include <crease/view/orthographic.hpp>
#include <crease/view/perspective.hpp>
#include <crease/view/reconstructed_normals.hpp>
#include <crease/view/second_view.hpp>

namespace crease {

/// Every part of crease, for recipes and lists.
inline constexpr const part* all_parts[] = {
    &directions_part::description,
    &hemisphere_points_part::description,
    &poisson_disk_part::description,
    &sphere_points_part::description,
    &sphere_lines_part::description,
    &hemisphere_lines_part::description,
    &box_window_part::description,
    &sample_box::description,
    &box_area_part::description,
    &single_layer::description,
    &stochastic_layers_part::description,
    &summed_area_part::description,
    &summed_area_uniform_part::description,
    &summed_area_adaptive_part::description,
    &n_buffer_part::description,
    &mip_chain_part::description,
    &hbao::description,
    &hbao_plus::description,
    &mean_height_part::description,
    &ssao::description,
    &point_volume::description,
    &line_volume::description,
    &unsharp_mask::description,
    &all_layers::description,
    &front_first_part::description,
    &deferred_layers_part::description,
    &work_efficient_scan::description,
    &subgroup_scan::description,
    &second_view_part::description,
    &centred_samples_part::description,
    &multisampled_part::description,
    &atomic_minimum_part::description,
    &stratified::description,
    &simple_hash::description,
    &hash_4d::description,
    &isotropic_threshold::description,
    &anisotropic_threshold::description,
    &visibility_only::description,
    &bent_cone::description,
    &packed_bent_cone::description,
    &shade_part::description,
    &bilateral_part::description,
    &upsample_part::description,
    &perspective::description,
    &orthographic::description,
    &device_depth::description,
    &linear_depth::description,
    &linearised_depth::description,
    &given_normals::description,
    &reconstructed_normals::description,
    &hashed_noise::description,
    &tiled_noise_part::description,
    &compute_part::description,
    &fragment::description,
    &functions_part::description,
    &vulkan_glsl::description,
    &opengl_glsl::description,
};

}
