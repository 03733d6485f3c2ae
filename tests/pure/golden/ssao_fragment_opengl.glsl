#version 430
#define crease_unroll
const int crease_hemisphere_points_count = 16;
const int crease_divisor = 1;
const int crease_view_index = 0;
#define crease_write(pixel, result) crease_output = crease_encode_visibility(result);
layout(binding = 0) uniform sampler2D crease_depth;
layout(location = 0) out vec4 crease_output;
#define crease_parameters_place std140, binding = 0
// SPDX-License-Identifier: MIT
struct crease_view_parameters {
    vec4 from_texel;
    vec2 depth_unpack;
    float far_depth;
    float guard;
    vec2 resolution;
    vec2 texel_size;
};

layout(crease_parameters_place) uniform crease_parameters {
    crease_view_parameters crease_views[2];
    mat4 crease_second_from_first;
    float crease_radius;
    float crease_bias;
    float crease_threshold;
    float crease_strength;
    float crease_exponent;
    float crease_sharpness;
    uint crease_frame;
    float crease_opacity;
    float crease_front_reach;
    float crease_falloff;
} crease_given;

// A camera as shaders use it: in their texel space whole numbers are the centres of the depth image's texels, those of
// the guard band too.
crease_view_parameters crease_view_of(int index) {
    crease_view_parameters view = crease_given.crease_views[index];
    view.from_texel.zw += (0.5 - view.guard) * view.from_texel.xy;
    return view;
}

// Read once, as not every compiler takes the reading out of a loop.
crease_view_parameters crease_view = crease_view_of(crease_view_index); // of the camera at work
float crease_radius = crease_given.crease_radius;
float crease_bias = crease_given.crease_bias;
float crease_threshold = crease_given.crease_threshold;
float crease_strength = crease_given.crease_strength;
float crease_exponent = crease_given.crease_exponent;
float crease_sharpness = crease_given.crease_sharpness;
uint crease_frame = crease_given.crease_frame;
float crease_opacity = crease_given.crease_opacity;
float crease_front_reach = crease_given.crease_front_reach;
float crease_falloff = crease_given.crease_falloff;
// SPDX-License-Identifier: MIT
// The depth of what is not there: further than any radius, and finite, so that its square is too.
const float crease_background = 1e15;

// What crease_view.far_depth is of the distance of the far plane: see set_projection.
const float crease_far_share = 0.999;

// Size in texels of an image whose sides are the picture's divided by `divisor`, rounded up.
ivec2 crease_size(int divisor) { return (ivec2(crease_view.resolution) + divisor - 1) / divisor; }

// Of the depth image in texels, guard band included.
vec2 crease_depth_size() { return crease_view.resolution + 2.0 * crease_view.guard; }

// Whether texel coordinates lie in the depth image. As whole numbers the bits of what is negative or NaN are greater
// than those of any size.
bool crease_inside(vec2 texel) {
    return all(lessThan(floatBitsToUint(texel), floatBitsToUint(crease_depth_size())));
}

// What is loaded in place of a texel beside the depth image, where reading would find anything at all.
const vec2 crease_first_texel = vec2(0.0);

// The texel that stands for a pixel of a picture that is smaller by `divisor`.
vec2 crease_texel_of_pixel(ivec2 pixel, int divisor) {
    return vec2(min(pixel * divisor + (divisor - 1) / 2, ivec2(crease_view.resolution) - 1)) + crease_view.guard;
}
// SPDX-License-Identifier: MIT
// What a pass computes for a pixel.
struct crease_result {
    float visibility; // 1 open, 0 closed
    float depth;      // positive, linear; crease_background where there is none
};

crease_result crease_open() { return crease_result(1.0, crease_background); }

crease_result crease_weighted(crease_result result, float weight) {
    return crease_result(result.visibility * weight, result.depth);
}

crease_result crease_sum(crease_result a, crease_result b) {
    return crease_result(a.visibility + b.visibility, a.depth);
}

// The mean out of a sum of weighted results and the sum of their weights.
crease_result crease_mean(crease_result sum, float weights, float depth) {
    return crease_result(sum.visibility / weights, depth);
}
// SPDX-License-Identifier: MIT
// The point whose visibility is asked for.
struct crease_receiver {
    ivec2 pixel;   // of the pass's output
    vec2 texel;    // texel space of the depth image
    vec3 position; // view space
    vec3 normal;   // view space, unit
    vec3 to_eye;   // view space, unit
    vec3 across, up; // view space, unit: the axes of the disk that faces the eye
    mat2 disk;       // offsets on that disk, in units of the AO radius, to texels
};
// SPDX-License-Identifier: MIT
// An orthographic projection, centred or not; depth standard or reversed.

float crease_linear_depth(float device) {
    float depth = device * crease_view.depth_unpack.x + crease_view.depth_unpack.y;
    return depth < crease_view.far_depth ? depth : crease_background; // the far plane occludes nothing
}

// How far rounding of the depth buffer, and of what is made of it, may bring two depths of one surface apart.
float crease_depth_rounding(float depth) { return 1.8e-7 * (depth + abs(depth - crease_view.depth_unpack.y)); }

vec3 crease_view_position(vec2 texel, float depth) {
    return vec3(texel * crease_view.from_texel.xy + crease_view.from_texel.zw, -depth);
}

vec2 crease_texel_at(vec3 position) {
    return (position.xy - crease_view.from_texel.zw) / crease_view.from_texel.xy;
}

vec3 crease_to_eye(vec3 position) { return vec3(0.0, 0.0, 1.0); }

void crease_axes(vec3 to_eye, out vec3 across, out vec3 up) {
    across = vec3(1.0, 0.0, 0.0);
    up = vec3(0.0, 1.0, 0.0);
}

mat2 crease_disk(vec3 position, vec3 across, vec3 up) {
    vec2 scale = crease_radius / crease_view.from_texel.xy;
    return mat2(scale.x, 0.0, 0.0, scale.y);
}
// SPDX-License-Identifier: MIT
// The depth image holds device depth, as the depth buffer does.

float crease_linear_depth(float device);

float crease_depth_at(vec2 texel) {
    return crease_linear_depth(textureLod(crease_depth, (texel + 0.5) * crease_view.texel_size, 0.0).x);
}
// SPDX-License-Identifier: MIT
// One layer of depth, that of the receivers.

float crease_depth_at(vec2 texel);

struct crease_layers {
    float depth;
};

crease_layers crease_fetch_layers(vec2 texel) { return crease_layers(crease_depth_at(texel)); }

int crease_layer_count() { return 1; }

float crease_layer_depth(crease_layers layers, int layer) { return layers.depth; }
// SPDX-License-Identifier: MIT
// The normal of the plane through the receiver and its neighbours: of left and right, and of up and down, the one
// that is nearer in depth.

float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
vec3 crease_to_eye(vec3 position);

vec3 crease_reconstructed_normals_tangent(vec2 texel, vec3 position, vec2 axis) {
    vec2 before_texel = texel - axis, after_texel = texel + axis;
    vec3 before = crease_view_position(before_texel, crease_depth_at(before_texel));
    vec3 after = crease_view_position(after_texel, crease_depth_at(after_texel));
    bool has_before = crease_inside(before_texel);
    bool has_after = crease_inside(after_texel);
    bool take_after = has_after && (!has_before || abs(after.z - position.z) < abs(before.z - position.z));
    return take_after ? after - position : position - before;
}

vec3 crease_normal_at(vec2 texel, vec3 position) {
    vec3 normal = cross(crease_reconstructed_normals_tangent(texel, position, vec2(1.0, 0.0)),
                        crease_reconstructed_normals_tangent(texel, position, vec2(0.0, 1.0)));
    float squared = dot(normal, normal);
    vec3 to_eye = crease_to_eye(position);
    if (!(squared > 0.0 && squared < 1e30)) // a picture one texel wide, or a neighbour that is not finite
        return to_eye;
    normal *= inversesqrt(squared);
    return dot(normal, to_eye) < 0.0 ? -normal : normal;
}
// SPDX-License-Identifier: MIT
// Two numbers in [0, 1) that differ from pixel to pixel and from frame to frame.

uvec3 crease_hashed_noise_mix(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v += v.yzx * v.zxy;
    v ^= v >> 16u;
    v += v.yzx * v.zxy;
    return v;
}

vec2 crease_noise(ivec2 pixel) {
    return vec2(crease_hashed_noise_mix(uvec3(uvec2(pixel), crease_frame)).xy >> 8u) * (1.0 / 16777216.0);
}
// SPDX-License-Identifier: MIT
// A tap at a point of view space, moved onto the ray through the centre of the texel that it falls into.
struct crease_tap {
    vec2 texel;
    bool inside; // whether the texel is in the depth image; else it has no weight
    vec3 offset; // from the receiver, view space
};

// The height over the tangent plane up to which a point says nothing, as rounding may put it on either side of a surface: a
// share of the radius, or of the depth where the radius is larger.
float crease_point_bias(crease_receiver receiver) {
    return crease_bias * min(crease_radius, -receiver.position.z);
}
// SPDX-License-Identifier: MIT
// The ray of a texel by the receiver: start + t * ray from it, where t counts depth and is 0 where the receiver is.
// Differences are of rays alone, as those of positions keep nothing of a radius that is small beside the distance.

vec3 crease_view_position(vec2 texel, float depth);

void crease_texel_ray(crease_receiver receiver, vec2 texel, out vec3 start, out vec3 ray) {
    vec3 eye = crease_view_position(texel, 0.0), own_eye = crease_view_position(receiver.texel, 0.0);
    vec3 own_ray = crease_view_position(receiver.texel, 1.0) - own_eye;
    ray = crease_view_position(texel, 1.0) - eye;
    start = (eye - own_eye) - (ray - own_ray) * receiver.position.z;
}
// SPDX-License-Identifier: MIT
// The radius in which a sampler looks for points: no larger than half the picture's diagonal at the receiver's depth, so that
// a radius that is larger than the picture still finds what is there.
float crease_radius_inside(crease_receiver receiver) {
    float texels = sqrt(abs(determinant(receiver.disk))); // of the radius
    return crease_radius * min(1.0, 0.5 * length(crease_depth_size()) / texels);
}
// SPDX-License-Identifier: MIT
// Points in the hemisphere over the receiver, turned about the normal by a random angle per pixel:
// stochastic-depth-ao 4.1. Directions are distributed by the cosine and distances evenly, so that the share of points
// behind a surface at distance d is the cosine-weighted occlusion with a linear falloff, 1 - d / R.

vec2 crease_noise(ivec2 pixel);
vec2 crease_texel_at(vec3 position);
float crease_radius_inside(crease_receiver receiver);
void crease_texel_ray(crease_receiver receiver, vec2 texel, out vec3 start, out vec3 ray);

struct crease_pattern {
    vec3 tangent, bitangent; // view space, unit
    vec2 direction;          // unit, in the tangent plane
    float radius;            // view space
    float distance;          // in radii
};

crease_pattern crease_pattern_begin(crease_receiver receiver) {
    vec2 noise = crease_noise(receiver.pixel);
    vec3 normal = receiver.normal;
    vec3 axis = abs(normal.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    vec3 tangent = normalize(cross(axis, normal));
    float angle = 6.28318531 * noise.x;
    return crease_pattern(tangent, cross(normal, tangent), vec2(cos(angle), sin(angle)),
                          crease_radius_inside(receiver), noise.y);
}

int crease_direction_count() { return 1; }

int crease_step_count() { return crease_hemisphere_points_count; }

vec2 crease_pattern_turn(inout crease_pattern pattern, crease_receiver receiver, int direction) { return vec2(0.0); }

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    const vec2 golden_angle = vec2(-0.73736888, 0.67549029);
    pattern.direction = vec2(golden_angle.x * pattern.direction.x - golden_angle.y * pattern.direction.y,
                             golden_angle.y * pattern.direction.x + golden_angle.x * pattern.direction.y);
    pattern.distance = fract(pattern.distance + 0.75487767);
    float share = (float(step) + 0.5) / float(crease_hemisphere_points_count);
    vec2 sideways = pattern.direction * sqrt(share);
    vec3 offset = (pattern.radius * pattern.distance) *
        (pattern.tangent * sideways.x + pattern.bitangent * sideways.y + receiver.normal * sqrt(1.0 - share));
    vec3 point = receiver.position + offset;
    vec2 texel = floor(crease_texel_at(point) + 0.5);
    vec3 start, ray;
    crease_texel_ray(receiver, texel, start, ray);
    vec3 moved = start - ray * offset.z;
    // A point that its texel moved out of the hemisphere says nothing; so a plane is unoccluded at every slant.
    bool above = dot(moved, receiver.normal) > 0.0;
    return crease_tap(texel, above && point.z < 0.0 && crease_inside(texel), moved);
}
// SPDX-License-Identifier: MIT
// Range-checked points: stochastic-depth-ao, Algorithm 1. Geometry further than the radius is ignored, as 4.1 says; the
// listing's smoothstep of R / |p.z - d| would leave half of it there at two radii. What hides a point from the eye and is
// out of range says nothing of it.

float crease_depth_rounding(float depth);
float crease_point_bias(crease_receiver receiver);

struct crease_estimate {
    float occluded; // points
    float points;
    float rounding; // of depth
};

struct crease_contribution {
    float occlusion;
    float points;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    return crease_estimate(0.0, 0.0, crease_depth_rounding(-receiver.position.z));
}

void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {}

// A point close to the tangent plane says nothing.
bool crease_ssao_over(crease_receiver receiver, crease_tap tap) {
    return dot(tap.offset, receiver.normal) > crease_point_bias(receiver);
}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    if (!tap.inside || !crease_ssao_over(receiver, tap))
        return crease_contribution(0.0, 0.0);
    float before = position.z - receiver.position.z;
    // Of layers that occlude nothing, one that leaves the point open counts before one that says nothing, and either before
    // none at all.
    if (before - estimate.rounding < tap.offset.z)
        return crease_contribution(position.z > -0.5 * crease_background ? 0.0 : -2e-6, 1.0);
    float in_range = smoothstep(0.0, 1.0, 2.0 * (1.0 - before / crease_radius));
    return crease_contribution(in_range > 0.0 ? in_range : -1e-6, in_range);
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.occluded += contribution.occlusion;
    estimate.points += contribution.points;
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.occluded / max(estimate.points, 1.0); }
// SPDX-License-Identifier: MIT
// Of what is gathered the occlusion, and nothing else.

struct crease_gathered {
    float occlusion;
};

crease_gathered crease_gathered_begin() { return crease_gathered(0.0); }

void crease_gathered_tap(inout crease_gathered gathered, crease_receiver receiver, crease_tap tap,
                         crease_contribution contribution) {}

void crease_gathered_turn(inout crease_gathered gathered, crease_receiver receiver, crease_estimate estimate,
                          vec2 direction) {}

void crease_gathered_end(inout crease_gathered gathered, crease_receiver receiver) {}

crease_gathered crease_gathered_turned_back(crease_gathered gathered, mat3 turn) { return gathered; }
// SPDX-License-Identifier: MIT
// The visibility of a receiver and nothing else.

float crease_visibility_of(float occlusion);

crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver) {
    return crease_result(crease_visibility_of(gathered.occlusion), -receiver.position.z);
}
// SPDX-License-Identifier: MIT
// The layers of a tap count as the one that occludes the most: stochastic-depth-ao 6.2, a-buffer-ssao III A.

int crease_layer_count();
float crease_layer_depth(crease_layers layers, int layer);
vec3 crease_view_position(vec2 texel, float depth);
crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position);

crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                crease_layers layers) {
    crease_contribution most = crease_weigh(
        estimate, receiver, tap, crease_view_position(tap.texel, crease_layer_depth(layers, 0)));
    crease_unroll for (int layer = 1; layer < crease_layer_count(); ++layer) {
        crease_contribution other = crease_weigh(
            estimate, receiver, tap, crease_view_position(tap.texel, crease_layer_depth(layers, layer)));
        if (other.occlusion > most.occlusion)
            most = other;
    }
    return most;
}
// SPDX-License-Identifier: MIT
// Taps of a direction that are asked for together.

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step);
crease_layers crease_fetch_layers(vec2 texel); // of any texel: beside the depth image what does not count

const int crease_batch_size = 4;

// Taps whose layers are fetched before any is weighed, so that the waits overlap.
struct crease_batch {
    crease_tap taps[crease_batch_size];
    crease_layers layers[crease_batch_size];
};

crease_batch crease_ask(inout crease_pattern pattern, crease_receiver receiver, int first, int count) {
    crease_batch batch;
    crease_unroll for (int i = 0; i < crease_batch_size; ++i)
        if (i < count) {
            batch.taps[i] = crease_pattern_tap(pattern, receiver, first + i);
            batch.layers[i] = crease_fetch_layers(batch.taps[i].texel);
        }
    return batch;
}
// SPDX-License-Identifier: MIT
// The loop of every technique: each tap of the sampler, each layer of the depth source, weighed by the estimator.

crease_pattern crease_pattern_begin(crease_receiver receiver);
int crease_direction_count();
int crease_step_count();
int crease_layer_count();
vec2 crease_pattern_turn(inout crease_pattern pattern, crease_receiver receiver, int direction);
crease_batch crease_ask(inout crease_pattern pattern, crease_receiver receiver, int first, int count);
crease_estimate crease_estimate_begin(crease_receiver receiver);
void crease_estimate_turn(inout crease_estimate estimate, vec2 direction);
crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                crease_layers layers);
void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution);
float crease_estimate_occlusion(crease_estimate estimate);
crease_gathered crease_gathered_begin();
void crease_gathered_tap(inout crease_gathered gathered, crease_receiver receiver, crease_tap tap,
                         crease_contribution contribution);
void crease_gathered_turn(inout crease_gathered gathered, crease_receiver receiver, crease_estimate estimate,
                          vec2 direction);
void crease_gathered_end(inout crease_gathered gathered, crease_receiver receiver);

// No loop is left where it is short, as a loop costs some drivers dearly: of all directions or else of one, up to so many
// layers of the taps.
const int crease_written_out = 128;

int crease_layers_of_direction() { return crease_step_count() * crease_layer_count(); }

void crease_gather_batch(inout crease_estimate estimate, inout crease_gathered gathered, inout crease_pattern pattern,
                         crease_receiver receiver, int first, int count) {
    crease_batch batch = crease_ask(pattern, receiver, first, count);
    crease_unroll for (int i = 0; i < crease_batch_size; ++i)
        if (i < count) {
            crease_contribution contribution = crease_fold(estimate, receiver, batch.taps[i], batch.layers[i]);
            crease_estimate_add(estimate, contribution);
            crease_gathered_tap(gathered, receiver, batch.taps[i], contribution);
        }
}

void crease_gather_direction(inout crease_estimate estimate, inout crease_gathered gathered,
                             inout crease_pattern pattern, crease_receiver receiver, int i) {
    vec2 direction = crease_pattern_turn(pattern, receiver, i);
    crease_estimate_turn(estimate, direction);
    int rest = crease_step_count() % crease_batch_size, whole = crease_step_count() - rest;
    if (crease_layers_of_direction() <= crease_written_out) {
        crease_unroll for (int step = 0; step < whole; step += crease_batch_size)
            crease_gather_batch(estimate, gathered, pattern, receiver, step, crease_batch_size);
    } else {
        for (int step = 0; step < whole; step += crease_batch_size)
            crease_gather_batch(estimate, gathered, pattern, receiver, step, crease_batch_size);
    }
    if (rest > 0)
        crease_gather_batch(estimate, gathered, pattern, receiver, whole, rest);
    crease_gathered_turn(gathered, receiver, estimate, direction);
}

crease_gathered crease_gather(crease_receiver receiver) {
    crease_pattern pattern = crease_pattern_begin(receiver);
    crease_estimate estimate = crease_estimate_begin(receiver);
    crease_gathered gathered = crease_gathered_begin();
    if (crease_direction_count() * crease_layers_of_direction() <= crease_written_out) {
        crease_unroll for (int i = 0; i < crease_direction_count(); ++i)
            crease_gather_direction(estimate, gathered, pattern, receiver, i);
    } else {
        for (int i = 0; i < crease_direction_count(); ++i)
            crease_gather_direction(estimate, gathered, pattern, receiver, i);
    }
    gathered.occlusion = crease_estimate_occlusion(estimate);
    crease_gathered_end(gathered, receiver);
    return gathered;
}
// SPDX-License-Identifier: MIT
// Visibility by strength and exponent: stochastic-depth-ao 8.1.
float crease_visibility_of(float occlusion) {
    return pow(clamp(1.0 - occlusion * crease_strength, 0.0, 1.0), crease_exponent);
}
// SPDX-License-Identifier: MIT
// Where a receiver stands, and how it looks around.

vec3 crease_to_eye(vec3 position);
void crease_axes(vec3 to_eye, out vec3 across, out vec3 up);
mat2 crease_disk(vec3 position, vec3 across, vec3 up);
float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
vec3 crease_normal_at(vec2 texel, vec3 position);

crease_receiver crease_receiver_at(ivec2 pixel, vec2 texel, vec3 position, vec3 normal) {
    crease_receiver receiver;
    receiver.pixel = pixel;
    receiver.texel = texel;
    receiver.position = position;
    receiver.normal = normal;
    receiver.to_eye = crease_to_eye(position);
    crease_axes(receiver.to_eye, receiver.across, receiver.up);
    receiver.disk = crease_disk(position, receiver.across, receiver.up);
    return receiver;
}

// The receiver that a pixel of the main pass sees; false where there is background.
bool crease_receive(ivec2 pixel, out crease_receiver receiver) {
    vec2 texel = crease_texel_of_pixel(pixel, crease_divisor);
    float depth = crease_depth_at(texel);
    if (!(depth > 0.0 && depth < crease_background))
        return false;
    vec3 position = crease_view_position(texel, depth);
    receiver = crease_receiver_at(pixel, texel, position, crease_normal_at(texel, position));
    return true;
}
// SPDX-License-Identifier: MIT
// Visibility alone.
vec4 crease_encode_visibility(crease_result result) { return vec4(result.visibility); }
// SPDX-License-Identifier: MIT
// The result of a pixel of the main pass.

bool crease_receive(ivec2 pixel, out crease_receiver receiver);
crease_gathered crease_gather(crease_receiver receiver);
crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver);
crease_result crease_open();

crease_result crease_evaluate(ivec2 pixel) {
    crease_receiver receiver;
    return crease_receive(pixel, receiver) ? crease_conclude(crease_gather(receiver), receiver) : crease_open();
}
// SPDX-License-Identifier: MIT
crease_result crease_evaluate(ivec2 pixel);

void main() {
    crease_result result = crease_evaluate(ivec2(gl_FragCoord.xy));
    crease_write(pixel, result)
}
