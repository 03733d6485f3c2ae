// SPDX-License-Identifier: MIT
// A host's own part of every role, each of which owns a resource, a step that fills it and a setting, and an
// effect with each.
#pragma once

#include <crease/crease.hpp>

#include <string_view>
#include <tuple>

namespace own {

using namespace crease;

// What each part owns, by its name: the image NAME_image, the step make_NAME that fills it, and the setting
// tint.
#define OWN_THINGS(name_)                                                                                    \
    namespace name_##_owns {                                                                                 \
        inline constexpr glsl_file make_glsl{"own/make_" #name_ ".glsl",                                     \
                                             "void crease_build(ivec2 texel) {\n"                            \
                                             "    imageStore(crease_" #name_                                 \
                                             "_image, texel, vec4(crease_" #name_ "_tint));\n}\n"};          \
        inline constexpr const glsl_file* making[] = {&make_glsl};                                           \
        inline constexpr std::string_view filled[] = {#name_ "_image"};                                      \
        inline constexpr resource image{.name = #name_ "_image",                                             \
                                        .texels = format::r32_float,                                         \
                                        .life = lifetime::transient,                                         \
                                        .read = crease::access::load};                                       \
        inline constexpr step make{                                                                          \
            .name = "make_" #name_, .files = making, .kind = step_kind::texels, .writes = filled};           \
        inline constexpr resource images[] = {image};                                                        \
        inline constexpr step steps[] = {make};                                                              \
        inline constexpr setting tint[] = {{"tint", 0.5f, 0, 1, "what the step makes"}};                     \
    }

// What a part's GLSL reads of it.
#define OWN_VALUE(name_)                                                                                     \
    "float crease_" #name_ "_value() { return crease_load_" #name_ "_image(ivec2(0)).x + crease_" #name_     \
    "_tint; }\n"

OWN_THINGS(own_projection)
struct own_projection {
    static constexpr glsl_file glsl{"own/projection.glsl", OWN_VALUE(own_projection) R"(
float crease_linear_depth(float device) { return device * crease_own_projection_value(); }
float crease_depth_rounding(float depth) { return 1e-6 * depth; }
vec3 crease_view_position(vec2 texel, float depth) { return vec3(texel, -depth); }
vec2 crease_texel_at(vec3 position) { return position.xy; }
vec3 crease_to_eye(vec3 position) { return vec3(0.0, 0.0, 1.0); }
void crease_axes(vec3 to_eye, out vec3 tangent, out vec3 bitangent) {
    tangent = vec3(1.0, 0.0, 0.0);
    bitangent = vec3(0.0, 1.0, 0.0);
}
mat2 crease_disk(vec3 position, vec3 tangent, vec3 bitangent) { return mat2(crease_radius); }
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr part description{.kind = role::projection,
                                      .name = "own_projection",
                                      .summary = "texels as they are",
                                      .source = "",
                                      .files = files,
                                      .settings = own_projection_owns::tint,
                                      .resources = own_projection_owns::images,
                                      .steps = own_projection_owns::steps};
};

OWN_THINGS(own_encoding)
struct own_encoding {
    static constexpr glsl_file glsl{"own/encoding.glsl", OWN_VALUE(own_encoding) R"(
float crease_depth_at(vec2 texel) { return texelFetch(crease_depth, ivec2(texel), 0).x * crease_own_encoding_value(); }
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr resource images[] = {
        {.name = "depth", .texels = format::r32_float, .size = {.guarded = true}}, own_encoding_owns::image};
    static constexpr part description{.kind = role::depth_encoding,
                                      .name = "own_encoding",
                                      .summary = "depth in other units",
                                      .source = "",
                                      .files = files,
                                      .settings = own_encoding_owns::tint,
                                      .resources = images,
                                      .steps = own_encoding_owns::steps};
};

OWN_THINGS(own_normals)
struct own_normals {
    static constexpr glsl_file glsl{"own/normals.glsl", OWN_VALUE(own_normals) R"(
vec3 crease_normal_at(vec2 texel, vec3 position) {
    return normalize(crease_to_eye(position) + crease_own_normals_value());
}
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr part description{.kind = role::normals,
                                      .name = "own_normals",
                                      .summary = "next to the eye's direction",
                                      .source = "",
                                      .files = files,
                                      .settings = own_normals_owns::tint,
                                      .resources = own_normals_owns::images,
                                      .steps = own_normals_owns::steps};
};

OWN_THINGS(own_noise)
struct own_noise {
    static constexpr glsl_file glsl{"own/noise.glsl", OWN_VALUE(own_noise) R"(
vec3 crease_noise(ivec2 pixel) { return vec3(crease_own_noise_value()); }
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr part description{.kind = role::noise,
                                      .name = "own_noise",
                                      .summary = "the same everywhere",
                                      .source = "",
                                      .files = files,
                                      .settings = own_noise_owns::tint,
                                      .resources = own_noise_owns::images,
                                      .steps = own_noise_owns::steps};
};

OWN_THINGS(own_views)
struct own_views {
    static constexpr glsl_file glsl{"own/views.glsl", OWN_VALUE(own_views) R"(
crease_result crease_result_of(crease_receiver receiver) {
    crease_view = crease_view_of(1);
    crease_view_index = 1;
    receiver.position = (crease_given.from_first[0] * vec4(receiver.position, 1.0)).xyz * crease_own_views_value();
    return crease_conclude(crease_gather(receiver), receiver);
}
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr part description{.kind = role::further_views,
                                      .name = "own_views",
                                      .summary = "from the second camera alone",
                                      .source = "",
                                      .files = files,
                                      .settings = own_views_owns::tint,
                                      .resources = own_views_owns::images,
                                      .steps = own_views_owns::steps,
                                      .further_views = {.count = 1}};
};

OWN_THINGS(own_coverage)
struct own_coverage {
    static constexpr glsl_file glsl{"own/coverage.glsl", OWN_VALUE(own_coverage) R"(
uint crease_kept_samples(vec3 anchor) {
    return fract(anchor.x) < crease_own_coverage_value() ? (1u << uint(crease_sample_count() - 1)) : 0u;
}
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr part description{.kind = role::coverage,
                                      .name = "own_coverage",
                                      .summary = "the last sample or none",
                                      .source = "",
                                      .files = files,
                                      .settings = own_coverage_owns::tint,
                                      .resources = own_coverage_owns::images,
                                      .steps = own_coverage_owns::steps};
};

OWN_THINGS(own_storage)
struct own_storage {
    static constexpr glsl_file glsl{"own/storage.glsl", R"(
float crease_captured_depth(ivec2 texel, int sample_index) {
    return uintBitsToFloat(crease_load_own_layers(ivec3(texel, sample_index)).x);
}
)"};
    static constexpr glsl_file draw_glsl{"own/storage_draw.glsl", OWN_VALUE(own_storage) R"(
void crease_capture(vec3 anchor) {
    uint bits = floatBitsToUint(crease_linear_depth(gl_FragCoord.z) + crease_own_storage_value());
    for (uint kept = crease_kept_samples(anchor); kept != 0u; kept &= kept - 1u)
        imageAtomicMin(crease_own_layers, ivec3(gl_FragCoord.xy, findLSB(kept)), bits);
}
)"};
    static constexpr const glsl_file *files[] = {&glsl}, *drawing[] = {&draw_glsl};
    static constexpr resource images[] = {{.name = "own_layers",
                                           .texels = format::r32_uint,
                                           .life = lifetime::transient,
                                           .size = {.guarded = true},
                                           .arrayed = true,
                                           .read = crease::access::load,
                                           .cleared = true,
                                           .clear = ~0u,
                                           .shape = shape_layers},
                                          own_storage_owns::image};
    static constexpr std::string_view captured[] = {"own_layers"};
    static constexpr step steps[] = {own_storage_owns::make,
                                     {.name = "draw_own_storage",
                                      .files = drawing,
                                      .kind = step_kind::geometry,
                                      .writes = captured,
                                      .how = crease::access::modify}};
    static constexpr part description{.kind = role::layer_storage,
                                      .name = "own_storage",
                                      .summary = "an image of its own",
                                      .source = "",
                                      .files = files,
                                      .numbers = capture_places,
                                      .settings = own_storage_owns::tint,
                                      .resources = images,
                                      .steps = steps};
    static constexpr int numbers[] = {0, 0, 0};
};

OWN_THINGS(own_scan)
struct own_scan {
    static constexpr glsl_file glsl{"own/scan.glsl", OWN_VALUE(own_scan) R"(
shared vec4 crease_own_scan_sums[crease_group_size.x * crease_group_size.y];

vec4 crease_scan_before(vec4 own, int along, int pieces, int stride) {
    int at = int(gl_LocalInvocationIndex);
    crease_own_scan_sums[at] = own;
    barrier();
    vec4 sum = vec4(0.0);
    for (int i = 1; i <= along; ++i)
        sum += crease_own_scan_sums[at - i * stride];
    return sum * crease_own_scan_value();
}
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr part description{.kind = role::scan,
                                      .name = "own_scan",
                                      .summary = "one piece after the other",
                                      .source = "",
                                      .files = files,
                                      .settings = own_scan_owns::tint,
                                      .resources = own_scan_owns::images,
                                      .steps = own_scan_owns::steps};
};

OWN_THINGS(own_compression)
struct own_compression {
    using needs = traits<layers_with_opacity, layers_alone>;
    static constexpr number takes[] = {{"nodes", 4, 4, 4, "layers that are kept"}};
    static constexpr glsl_file glsl{"own/compression.glsl", OWN_VALUE(own_compression) R"(
const int crease_most_layers = crease_own_compression_nodes;
const int crease_first_to_go = crease_own_compression_nodes;

void crease_pack_fragments(ivec2 texel, crease_fragments sorted) {
    crease_nodes nodes = crease_begin_nodes();
    for (int i = 0; i < crease_most_surfaces; ++i)
        if (sorted.keys[i] != crease_no_fragment)
            crease_add_node(nodes, uintBitsToFloat(sorted.keys[i] >> 1) * crease_own_compression_value(),
                            crease_fragment_surface(texel, sorted.places[i]));
    crease_store_nodes(texel, nodes);
}
)"};
    static constexpr const glsl_file* files[] = {&glsl, &nodes_glsl};
    static constexpr part description{.kind = role::layer_compression,
                                      .name = "own_compression",
                                      .summary = "the nearest, a little moved",
                                      .source = "",
                                      .files = files,
                                      .numbers = takes,
                                      .settings = own_compression_owns::tint,
                                      .resources = own_compression_owns::images,
                                      .steps = own_compression_owns::steps,
                                      .needs = needs::list};
    static constexpr int numbers[] = {4};
};

OWN_THINGS(own_resolutions)
struct own_resolutions {
    static constexpr glsl_file glsl{"own/resolutions.glsl", OWN_VALUE(own_resolutions) R"(
crease_result crease_result_of(crease_receiver receiver) {
    receiver.disk_x *= crease_own_resolutions_value();
    receiver.disk_y *= crease_own_resolutions_value();
    return crease_conclude(crease_gather(receiver), receiver);
}
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr part description{.kind = role::resolutions,
                                      .name = "own_resolutions",
                                      .summary = "a share of the radius",
                                      .source = "",
                                      .files = files,
                                      .settings = own_resolutions_owns::tint,
                                      .resources = own_resolutions_owns::images,
                                      .steps = own_resolutions_owns::steps};
};

OWN_THINGS(own_source)
struct own_source {
    static constexpr glsl_file glsl{"own/source.glsl", OWN_VALUE(own_source) R"(
struct crease_layers {
    vec2 texel;
    float depth;
};
const int crease_most_layers = 2;
crease_layers crease_fetch_layers(vec2 texel) { return crease_layers(texel, crease_depth_at(texel)); }
int crease_layer_count(crease_layers layers) { return crease_most_layers; }
crease_layer crease_layer_at(crease_layers layers, int i) {
    float depth = layers.depth + float(i) * crease_own_source_value();
    return crease_layer(crease_view_position(layers.texel, depth), 1.0);
}
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr part description{.kind = role::depth_source,
                                      .name = "own_source",
                                      .summary = "a second layer behind the first",
                                      .source = "",
                                      .files = files,
                                      .settings = own_source_owns::tint,
                                      .resources = own_source_owns::images,
                                      .steps = own_source_owns::steps,
                                      .offers = traits<depth_layers>::list};
};

OWN_THINGS(own_sampler)
struct own_sampler {
    static constexpr glsl_file glsl{"own/sampler.glsl", OWN_VALUE(own_sampler) R"(
struct crease_pattern { float angle; };
crease_pattern crease_pattern_begin(crease_receiver receiver) {
    return crease_pattern(crease_own_sampler_value() + crease_noise(receiver.pixel).x);
}
int crease_direction_count() { return 1; }
int crease_step_count() { return crease_own_sampler_taps; }
vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) {
    return vec2(cos(pattern.angle), sin(pattern.angle));
}
crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    vec2 texel = floor(receiver.texel + crease_disk_of(receiver) * vec2(float(step + 1) / float(crease_own_sampler_taps)));
    return crease_tap(texel, crease_inside(texel), 1.0);
}
)"};
    static constexpr const glsl_file* files[] = {&screen_tap_glsl, &glsl};
    static constexpr number takes[] = {{"taps", 1, 16, 4, "on a line"}};
    static constexpr part description{.kind = role::sampler,
                                      .name = "own_sampler",
                                      .summary = "one line",
                                      .source = "",
                                      .files = files,
                                      .numbers = takes,
                                      .settings = own_sampler_owns::tint,
                                      .resources = own_sampler_owns::images,
                                      .steps = own_sampler_owns::steps,
                                      .offers = traits<screen_taps>::list};
    static constexpr int numbers[] = {6};
};

OWN_THINGS(own_estimator)
struct own_estimator {
    using needs = traits<screen_taps, depth_layers>;
    static constexpr glsl_file glsl{"own/estimator.glsl", OWN_VALUE(own_estimator) R"(
struct crease_estimate { float occlusion; };
struct crease_march { float occlusion; };
struct crease_contribution { float occlusion; };
crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0); }
crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    return crease_march(0.0);
}
crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    bool near = tap.inside && distance(layer.position, receiver.position) < crease_radius;
    return crease_contribution(near ? crease_own_estimator_value() : 0.0);
}
void crease_add(inout crease_march march, crease_contribution contribution) {
    march.occlusion += contribution.occlusion;
}
void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    estimate.occlusion += march.occlusion;
}
float crease_estimate_occlusion(crease_estimate estimate) {
    return estimate.occlusion / float(crease_own_estimator_most);
}
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr number takes[] = {{"most", 1, 99, 10, "taps that darken fully"}};
    static constexpr setting reads[] = {own_estimator_owns::tint[0], strength_setting(1),
                                        exponent_setting(1)};
    static constexpr part description{.kind = role::estimator,
                                      .name = "own_estimator",
                                      .summary = "counts what is near",
                                      .source = "",
                                      .files = files,
                                      .numbers = takes,
                                      .settings = reads,
                                      .resources = own_estimator_owns::images,
                                      .steps = own_estimator_owns::steps,
                                      .needs = needs::list};
    static constexpr int numbers[] = {20};
};

OWN_THINGS(own_traversal)
struct own_traversal {
    static constexpr glsl_file glsl{"own/traversal.glsl", OWN_VALUE(own_traversal) R"(
struct crease_fetched { crease_layers layers; };
crease_fetched crease_fetch(vec2 texel) { return crease_fetched(crease_fetch_layers(texel)); }
void crease_traverse(inout crease_march march, crease_receiver receiver, crease_tap tap, crease_fetched fetched) {
    crease_layer layer = crease_layer_at(fetched.layers, 0);
    layer.position.z -= crease_own_traversal_value();
    crease_add(march, crease_weigh(march, receiver, tap, layer));
}
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr part description{.kind = role::layer_traversal,
                                      .name = "own_traversal",
                                      .summary = "the first layer alone",
                                      .source = "",
                                      .files = files,
                                      .settings = own_traversal_owns::tint,
                                      .resources = own_traversal_owns::images,
                                      .steps = own_traversal_owns::steps};
};

OWN_THINGS(own_receivers)
struct own_receivers {
    static constexpr glsl_file glsl{"own/receivers.glsl", OWN_VALUE(own_receivers) R"(
crease_result crease_evaluate(ivec2 pixel) {
    vec2 texel = crease_texel_of_pixel(pixel, crease_divisor);
    vec3 position = crease_view_position(texel, crease_depth_at(texel) * crease_own_receivers_value());
    return crease_result_of(crease_make_receiver(pixel, texel, position, crease_normal_at(texel, position)));
}
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr part description{.kind = role::receivers,
                                      .name = "own_receivers",
                                      .summary = "a surface in front of the first",
                                      .source = "",
                                      .files = files,
                                      .settings = own_receivers_owns::tint,
                                      .resources = own_receivers_owns::images,
                                      .steps = own_receivers_owns::steps};
};

OWN_THINGS(own_output)
struct own_output {
    static constexpr glsl_file glsl{"own/output.glsl", OWN_VALUE(own_output) R"(
struct crease_result { float visibility; };
crease_result crease_open_result() { return crease_result(1.0); }
crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver) {
    return crease_result(crease_visibility_of(crease_estimate_occlusion(gathered.estimate)));
}
vec4 crease_encode_visibility(crease_result result) { return vec4(result.visibility); }
vec4 crease_encode_own_shadow(crease_result result) { return vec4(1.0 - result.visibility + crease_own_output_value()); }
vec4 crease_encode_between(crease_result result) { return vec4(result.visibility); }
crease_result crease_decode(vec4 texel) { return crease_result(texel.x); }
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr resource images[] = {between_image(format::r32_float),
                                          visibility_image,
                                          {.name = "own_shadow",
                                           .texels = format::r32_float,
                                           .life = lifetime::output,
                                           .read = crease::access::load},
                                          own_output_owns::image};
    static constexpr part description{.kind = role::output,
                                      .name = "own_output",
                                      .summary = "visibility, and what is left of 1",
                                      .source = "",
                                      .files = files,
                                      .settings = own_output_owns::tint,
                                      .resources = images,
                                      .steps = own_output_owns::steps};
};

OWN_THINGS(own_format)
struct own_format {
    static constexpr glsl_file glsl{"own/format.glsl", OWN_VALUE(own_format) R"(
float crease_visibility_of(float occlusion) { return 1.0 - occlusion * crease_own_format_value(); }
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr part description{.kind = role::output_format,
                                      .name = "own_format",
                                      .summary = "a number, and a default of its own",
                                      .source = "",
                                      .files = files,
                                      .settings = own_format_owns::tint,
                                      .resources = own_format_owns::images,
                                      .steps = own_format_owns::steps,
                                      .offers = traits<real_number>::list};
};

OWN_THINGS(own_filter)
struct own_filter {
    static constexpr glsl_file glsl{"own/filter.glsl", OWN_VALUE(own_filter) R"(
crease_result crease_evaluate(ivec2 pixel) {
    crease_result own = crease_decode(crease_load_input(pixel));
    own.visibility *= crease_own_filter_value() * float(crease_own_filter_twice);
    return own;
}
)"};
    static constexpr const glsl_file* filtering[] = {&glsl};
    static constexpr glsl_file count_glsl{"own/count.glsl", R"(
void crease_build(ivec2 texel) { imageStore(crease_own_count, texel, vec4(crease_own_filter_tint)); }
)"};
    static constexpr const glsl_file* counting[] = {&count_glsl};
    static constexpr std::string_view counted[] = {"own_count"};
    static constexpr step_constant twice[] = {{"twice", 2}};
    static constexpr resource images[] = {own_filter_owns::image,
                                          {.name = "own_count",
                                           .texels = format::r32_float,
                                           .life = lifetime::report,
                                           .size = {.fixed_width = 1, .fixed_height = 1}}};
    static constexpr step steps[] = {{.name = "count_own_filter",
                                      .files = counting,
                                      .kind = step_kind::texels,
                                      .after = true,
                                      .writes = counted,
                                      .group_width = 8,
                                      .group_height = 4},
                                     {.name = "own_filter", .files = filtering, .constants = twice},
                                     own_filter_owns::make};
    static constexpr part description{.kind = role::filter,
                                      .name = "own_filter",
                                      .summary = "a factor",
                                      .source = "",
                                      .settings = own_filter_owns::tint,
                                      .resources = images,
                                      .steps = steps};
};

OWN_THINGS(own_reads)
struct own_reads {
    static constexpr glsl_file glsl{"own/reads.glsl", OWN_VALUE(own_reads) R"(
float crease_visibility_of(float occlusion) { return 1.0 - occlusion * crease_own_reads_value(); }
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr part description{.kind = role::image_reads,
                                      .name = "own_reads",
                                      .summary = "fetches, and a default of its own",
                                      .source = "",
                                      .files = files,
                                      .settings = own_reads_owns::tint,
                                      .resources = own_reads_owns::images,
                                      .steps = own_reads_owns::steps};
};

OWN_THINGS(own_stage)
struct own_stage {
    static constexpr glsl_file glsl{"own/stage.glsl", OWN_VALUE(own_stage) R"(
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, crease_size(crease_divisor))))
        return;
    crease_result result = crease_evaluate(pixel);
    result.visibility *= crease_own_stage_value();
    crease_write(pixel, result)
}
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr part description{.kind = role::stage,
                                      .name = "own_stage",
                                      .summary = "compute in rows",
                                      .source = "",
                                      .files = files,
                                      .numbers = compute_part::takes,
                                      .settings = own_stage_owns::tint,
                                      .resources = own_stage_owns::images,
                                      .steps = own_stage_owns::steps};
    static constexpr int numbers[] = {64, 2};
};

OWN_THINGS(own_dialect)
struct own_dialect {
    static constexpr glsl_file glsl{"own/dialect.glsl", OWN_VALUE(own_dialect) R"(
float crease_visibility_of(float occlusion) { return 1.0 - occlusion * crease_own_dialect_value(); }
)"};
    static constexpr const glsl_file* files[] = {&glsl};
    static constexpr part description{.kind = role::dialect,
                                      .name = "own_dialect",
                                      .summary = "that of Vulkan, and a default of its own",
                                      .source = "",
                                      .files = files,
                                      .settings = own_dialect_owns::tint,
                                      .resources = own_dialect_owns::images,
                                      .steps = own_dialect_owns::steps};
};

#undef OWN_THINGS
#undef OWN_VALUE

/// An effect with a part of a host, and the recipe of the same.
template <class Part, class Effect>
struct example {
    using part_type = Part;
    using effect_type = Effect;
    std::string_view recipe;
};

/// One for each role.
inline constexpr std::tuple examples{
    example<own_projection, effect<directions<>, single_layer, hbao_plus, own_projection>>{
        "directions/single_layer/hbao_plus/own_projection"},
    example<own_encoding, effect<directions<>, single_layer, hbao_plus, own_encoding>>{
        "directions/single_layer/hbao_plus/own_encoding"},
    example<own_normals, effect<directions<>, single_layer, hbao_plus, own_normals>>{
        "directions/single_layer/hbao_plus/own_normals"},
    example<own_noise, effect<directions<>, single_layer, hbao_plus, own_noise>>{
        "directions/single_layer/hbao_plus/own_noise"},
    example<own_views, effect<directions<>, single_layer, hbao_plus, own_views>>{
        "directions/single_layer/hbao_plus/own_views"},
    example<own_coverage, effect<directions<>, stochastic_layers<>, hbao_plus, own_coverage>>{
        "directions/stochastic_layers/hbao_plus/own_coverage"},
    example<own_storage, effect<directions<>, stochastic_layers<>, hbao_plus, own_storage>>{
        "directions/stochastic_layers/hbao_plus/own_storage"},
    example<own_scan, effect<sample_box, summed_area<>, mean_height<>, own_scan>>{
        "sample_box/summed_area/mean_height/own_scan"},
    example<own_compression, effect<directions<>, linked_lists<>, hbao_plus, own_compression>>{
        "directions/linked_lists/hbao_plus/own_compression"},
    example<own_resolutions, effect<directions<>, single_layer, hbao_plus, own_resolutions>>{
        "directions/single_layer/hbao_plus/own_resolutions"},
    example<own_source, effect<directions<>, own_source, hbao_plus>>{"directions/own_source/hbao_plus"},
    example<own_sampler, effect<own_sampler, single_layer, hbao_plus>>{
        "own_sampler:6/single_layer/hbao_plus"},
    example<own_estimator, effect<poisson_disk<>, single_layer, own_estimator>>{
        "poisson_disk/single_layer/own_estimator:20"},
    example<own_traversal, effect<directions<>, single_layer, hbao_plus, own_traversal>>{
        "directions/single_layer/hbao_plus/own_traversal"},
    example<own_receivers, effect<directions<>, single_layer, hbao_plus, own_receivers>>{
        "directions/single_layer/hbao_plus/own_receivers"},
    example<own_output, effect<directions<>, single_layer, hbao_plus, own_output>>{
        "directions/single_layer/hbao_plus/own_output"},
    example<own_format, effect<directions<>, single_layer, hbao_plus, own_format>>{
        "directions/single_layer/hbao_plus/own_format"},
    example<own_filter, effect<directions<>, single_layer, hbao_plus, own_filter>>{
        "directions/single_layer/hbao_plus/own_filter"},
    example<own_reads, effect<directions<>, single_layer, hbao_plus, own_reads>>{
        "directions/single_layer/hbao_plus/own_reads"},
    example<own_stage, effect<directions<>, single_layer, hbao_plus, own_stage>>{
        "directions/single_layer/hbao_plus/own_stage:64x2"},
    example<own_dialect, effect<directions<>, single_layer, hbao_plus, own_dialect>>{
        "directions/single_layer/hbao_plus/own_dialect"}};

/// Effects in which parts of a host meet each other.
inline constexpr std::tuple mixtures{
    example<own_filter, effect<own_sampler, own_source, own_estimator, own_filter, own_output, own_noise>>{
        "own_sampler:6/own_source/own_estimator:20/own_filter/own_output/own_noise"},
    example<own_storage, effect<directions<>, stochastic_layers<>, hbao_plus, own_storage, own_coverage,
                                own_normals, own_projection, bilateral<>, upsample<>>>{
        "directions/stochastic_layers/hbao_plus/own_storage/own_coverage/own_normals/own_projection/"
        "bilateral/"
        "upsample"}};

/// Calls `action` with each.
template <class Action>
void for_each_example(Action action) {
    const auto all = [&action](const auto&... each) { (action(each), ...); };
    std::apply(all, examples);
    std::apply(all, mixtures);
}

}
