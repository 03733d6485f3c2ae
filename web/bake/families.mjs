// SPDX-License-Identifier: MIT
// What the gallery shows: a recipe of each family, and the part that it is there for.

export const families = [
    {part: 'hbao', title: 'HBAO', recipe: 'directions:8x4/single_layer/hbao/bilateral'},
    {part: 'hbao_plus', title: 'HBAO+', recipe: 'poisson_disk/single_layer/hbao_plus/bilateral'},
    {part: 'gtao', title: 'GTAO', recipe: 'slices/single_layer/gtao/separable_plane_filter'},
    {part: 'visibility_bitmask', title: 'Visibility bitmask', recipe: 'slices/single_layer/visibility_bitmask/separable_plane_filter'},
    {part: 'cosine_bitmask', title: 'Preset low', recipe: 'preset:low'},
    {part: 'cosine_bitmask', title: 'Preset medium', recipe: 'preset:medium'},
    {part: 'cosine_bitmask', title: 'Preset ultra', recipe: 'preset:ultra'},
    {part: 'ssao', title: 'SSAO', recipe: 'hemisphere_points/single_layer/ssao/bilateral'},
    {part: 'point_volume', title: 'Volume by points', recipe: 'hemisphere_points:17/single_layer/point_volume/tiled_noise/bilateral'},
    {part: 'line_volume', title: 'Volume by lines', recipe: 'hemisphere_lines:12/single_layer/line_volume/tiled_noise/bilateral'},
    {part: 'unsharp_mask', title: 'Unsharp mask', recipe: 'box_window:15/single_layer/unsharp_mask'},
    {part: 'summed_area', title: 'Areas', recipe: 'sample_box/summed_area/mean_height'},
    {part: 'summed_area_adaptive', title: 'Areas, adaptive layers', recipe: 'sample_box/summed_area_adaptive:4x2/mean_height'},
    {part: 'depth_pyramid', title: 'Depth pyramid', recipe: 'directions:8x4/depth_pyramid/hbao/bilateral'},
    {part: 'multi_resolution', title: 'Multi-resolution', recipe: 'tap_grid/single_layer/hbao_plus/multi_resolution'},
    {part: 'stochastic_layers', title: 'Stochastic layers', recipe: 'directions:8x4/stochastic_layers:8/hbao/bilateral'},
    {part: 'layer_array', title: 'Exact layers', recipe: 'directions:8x4/layer_array/hbao/bilateral'},
    {part: 'stochastic_layers', title: 'Preset ultra layers', recipe: 'preset:ultra_layers'},
    {part: 'second_view', title: 'A second view', recipe: 'hemisphere_points/stochastic_layers/ssao/second_view/bilateral'},
];
