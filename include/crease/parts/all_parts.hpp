// SPDX-License-Identifier: MIT
#pragma once

// The index of all parts. To add one: its GLSL in templates/crease/<role>/<name>.glsl, its struct in
// include/crease/parts/<role>/<name>.hpp, one include and one line here beside those of its role, and its
// tests in tests/pure/parts/<role>/<name>.cpp.

#include <crease/parts/compression/compressed.hpp>
#include <crease/parts/compression/compressed_occluders.hpp>
#include <crease/parts/coverage/anisotropic_threshold.hpp>
#include <crease/parts/coverage/hash_4d.hpp>
#include <crease/parts/coverage/isotropic_threshold.hpp>
#include <crease/parts/coverage/simple_hash.hpp>
#include <crease/parts/coverage/stratified.hpp>
#include <crease/parts/depth/depth_pyramid.hpp>
#include <crease/parts/depth/dual_peeled_layers.hpp>
#include <crease/parts/depth/layer_array.hpp>
#include <crease/parts/depth/linear_lists.hpp>
#include <crease/parts/depth/linked_lists.hpp>
#include <crease/parts/depth/mip_chain.hpp>
#include <crease/parts/depth/n_buffer.hpp>
#include <crease/parts/depth/peeled_layers.hpp>
#include <crease/parts/depth/separated_layers.hpp>
#include <crease/parts/depth/single_layer.hpp>
#include <crease/parts/depth/static_and_dynamic_layers.hpp>
#include <crease/parts/depth/stochastic_layers.hpp>
#include <crease/parts/depth/summed_area.hpp>
#include <crease/parts/depth/summed_area_adaptive.hpp>
#include <crease/parts/depth/summed_area_uniform.hpp>
#include <crease/parts/dialect/glsl_es.hpp>
#include <crease/parts/dialect/opengl.hpp>
#include <crease/parts/dialect/vulkan.hpp>
#include <crease/parts/dialect/webgpu.hpp>
#include <crease/parts/estimator/cosine_bitmask.hpp>
#include <crease/parts/estimator/gtao.hpp>
#include <crease/parts/estimator/hbao.hpp>
#include <crease/parts/estimator/hbao_plus.hpp>
#include <crease/parts/estimator/line_volume.hpp>
#include <crease/parts/estimator/mean_height.hpp>
#include <crease/parts/estimator/point_volume.hpp>
#include <crease/parts/estimator/ssao.hpp>
#include <crease/parts/estimator/unsharp_mask.hpp>
#include <crease/parts/estimator/visibility_bitmask.hpp>
#include <crease/parts/filter/bilateral.hpp>
#include <crease/parts/filter/plane_filter.hpp>
#include <crease/parts/filter/separable_plane_filter.hpp>
#include <crease/parts/filter/upsample.hpp>
#include <crease/parts/noise/blue_noise.hpp>
#include <crease/parts/noise/hashed_noise.hpp>
#include <crease/parts/noise/hilbert_r2_noise.hpp>
#include <crease/parts/noise/interleaved_gradient_noise.hpp>
#include <crease/parts/noise/tiled_noise.hpp>
#include <crease/parts/output/bent_cone.hpp>
#include <crease/parts/output/composite.hpp>
#include <crease/parts/output/packed_bent_cone.hpp>
#include <crease/parts/output/shade.hpp>
#include <crease/parts/output/visibility_only.hpp>
#include <crease/parts/output_format/r32f.hpp>
#include <crease/parts/output_format/r8.hpp>
#include <crease/parts/output_format/rgba8.hpp>
#include <crease/parts/reads/image_load.hpp>
#include <crease/parts/reads/texel_fetch.hpp>
#include <crease/parts/receivers/every_layer.hpp>
#include <crease/parts/receivers/first_surface.hpp>
#include <crease/parts/receivers/thin_layers.hpp>
#include <crease/parts/resolutions/multi_resolution.hpp>
#include <crease/parts/sampler/axes.hpp>
#include <crease/parts/sampler/box_area.hpp>
#include <crease/parts/sampler/box_window.hpp>
#include <crease/parts/sampler/directions.hpp>
#include <crease/parts/sampler/half_directions.hpp>
#include <crease/parts/sampler/hemisphere_lines.hpp>
#include <crease/parts/sampler/hemisphere_points.hpp>
#include <crease/parts/sampler/poisson_disk.hpp>
#include <crease/parts/sampler/sample_box.hpp>
#include <crease/parts/sampler/slices.hpp>
#include <crease/parts/sampler/sphere_lines.hpp>
#include <crease/parts/sampler/sphere_points.hpp>
#include <crease/parts/sampler/tap_grid.hpp>
#include <crease/parts/scan/subgroup_scan.hpp>
#include <crease/parts/scan/work_efficient_scan.hpp>
#include <crease/parts/stage/compute.hpp>
#include <crease/parts/stage/compute_columns.hpp>
#include <crease/parts/stage/compute_strips.hpp>
#include <crease/parts/stage/fragment.hpp>
#include <crease/parts/stage/functions.hpp>
#include <crease/parts/storage/atomic_minimum.hpp>
#include <crease/parts/storage/centred_samples.hpp>
#include <crease/parts/storage/multisampled.hpp>
#include <crease/parts/traversal/all_layers.hpp>
#include <crease/parts/traversal/area_layers.hpp>
#include <crease/parts/traversal/deferred_layers.hpp>
#include <crease/parts/traversal/front_first.hpp>
#include <crease/parts/view/device_depth.hpp>
#include <crease/parts/view/further_views.hpp>
#include <crease/parts/view/given_normals.hpp>
#include <crease/parts/view/linear_depth.hpp>
#include <crease/parts/view/linearised_depth.hpp>
#include <crease/parts/view/logarithmic_depth.hpp>
#include <crease/parts/view/octahedral_normals.hpp>
#include <crease/parts/view/octahedral_world_normals.hpp>
#include <crease/parts/view/orthographic.hpp>
#include <crease/parts/view/packed_normals.hpp>
#include <crease/parts/view/packed_world_normals.hpp>
#include <crease/parts/view/perspective.hpp>
#include <crease/parts/view/reconstructed_normals.hpp>
#include <crease/parts/view/second_view.hpp>
#include <crease/parts/view/world_normals.hpp>

namespace crease {

/// Every part of crease, for recipes and lists.
inline constexpr const part* all_parts[] = {
    &directions_part::description,
    &half_directions_part::description,
    &slices_part::description,
    &axes_part::description,
    &hemisphere_points_part::description,
    &poisson_disk_part::description,
    &tap_grid_part::description,
    &sphere_points_part::description,
    &sphere_lines_part::description,
    &hemisphere_lines_part::description,
    &box_window_part::description,
    &sample_box::description,
    &box_area_part::description,
    &single_layer::description,
    &stochastic_layers_part::description,
    &layer_array_part::description,
    &linked_lists_part::description,
    &linear_lists_part::description,
    &peeled_layers_part::description,
    &dual_peeled_layers_part::description,
    &separated_layers_part::description,
    &static_and_dynamic_layers_part::description,
    &summed_area_part::description,
    &summed_area_uniform_part::description,
    &summed_area_adaptive_part::description,
    &n_buffer_part::description,
    &mip_chain_part::description,
    &depth_pyramid_part::description,
    &compressed_part::description,
    &compressed_occluders_part::description,
    &multi_resolution_part::description,
    &hbao::description,
    &hbao_plus::description,
    &gtao::description,
    &visibility_bitmask::description,
    &cosine_bitmask_part::description,
    &mean_height_part::description,
    &ssao::description,
    &point_volume::description,
    &line_volume::description,
    &unsharp_mask::description,
    &all_layers::description,
    &area_layers::description,
    &front_first_part::description,
    &deferred_layers_part::description,
    &work_efficient_scan::description,
    &subgroup_scan::description,
    &second_view_part::description,
    &further_views_part::description,
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
    &composite_part::description,
    &r8::description,
    &rgba8::description,
    &r32f::description,
    &bilateral_part::description,
    &plane_filter_part::description,
    &separable_plane_filter_part::description,
    &upsample_part::description,
    &perspective::description,
    &orthographic::description,
    &device_depth::description,
    &linear_depth::description,
    &linearised_depth::description,
    &logarithmic_depth::description,
    &given_normals::description,
    &packed_normals::description,
    &octahedral_normals::description,
    &world_normals::description,
    &packed_world_normals::description,
    &octahedral_world_normals::description,
    &reconstructed_normals::description,
    &hashed_noise::description,
    &tiled_noise_part::description,
    &interleaved_gradient_noise::description,
    &hilbert_r2_noise::description,
    &blue_noise::description,
    &first_surface::description,
    &every_layer::description,
    &thin_layers::description,
    &texel_fetch::description,
    &image_load::description,
    &compute_part::description,
    &compute_columns_part::description,
    &compute_strips_part::description,
    &fragment::description,
    &functions_part::description,
    &vulkan_glsl::description,
    &opengl_glsl::description,
    &glsl_es_part::description,
    &webgpu_glsl::description,
};

}
