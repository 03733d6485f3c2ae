#version 450
#extension GL_EXT_control_flow_attributes : enable
#define crease_unroll [[unroll]]
layout(local_size_x = 16, local_size_y = 16, local_size_x_id = 0, local_size_y_id = 1) in;
layout(constant_id = 2) const int crease_directions_count = 8;
layout(constant_id = 3) const int crease_directions_steps = 4;
const int crease_divisor = 1;
const int crease_view_index = 0;
#define crease_write(pixel, result) imageStore(crease_output, pixel, crease_encode_visibility(result));
layout(set = 0, binding = 1) uniform sampler2D crease_depth;
layout(set = 0, binding = 2) uniform sampler2D crease_normal;
layout(r8, set = 0, binding = 3) uniform writeonly image2D crease_output;
#define crease_parameters_place std140, set = 0, binding = 0
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
// A perspective projection, centred or not; depth standard, reversed or infinite: stochastic-depth-ao 4.4.

float crease_linear_depth(float device) {
    float inverse = device * crease_view.depth_unpack.x + crease_view.depth_unpack.y;
    return inverse * crease_view.far_depth > 1.0 ? 1.0 / inverse : crease_background; // the far plane occludes nothing
}

vec3 crease_view_position(vec2 texel, float depth) {
    return vec3(texel * crease_view.from_texel.xy + crease_view.from_texel.zw, -1.0) * depth;
}

vec2 crease_texel_at(vec3 position) {
    return (position.xy / -position.z - crease_view.from_texel.zw) / crease_view.from_texel.xy;
}

vec3 crease_to_eye(vec3 position) { return -normalize(position); }

void crease_axes(vec3 to_eye, out vec3 across, out vec3 up) {
    across = normalize(vec3(to_eye.z, 0.0, -to_eye.x));
    up = cross(to_eye, across);
}

// Derivative of the projection at `position` along two axes that face the eye, times the radius.
mat2 crease_disk(vec3 position, vec3 across, vec3 up) {
    vec2 ray = position.xy / -position.z;
    vec2 scale = crease_radius / (-position.z * crease_view.from_texel.xy);
    return mat2((across.xy + ray * across.z) * scale, (up.xy + ray * up.z) * scale);
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
// The normals image holds view-space normals, facing the camera, of any length; one that has no direction counts as
// facing the eye.

vec3 crease_to_eye(vec3 position);

vec3 crease_normal_at(vec2 texel, vec3 position) {
    vec3 normal = textureLod(crease_normal, (texel + 0.5) * crease_view.texel_size, 0.0).xyz;
    float squared = dot(normal, normal);
    return squared > 0.0 && squared < 1.0e30 ? normal * inversesqrt(squared) : crease_to_eye(position);
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
// A tap on the screen, at the centre of a texel.
struct crease_tap {
    vec2 texel;
    bool inside; // whether the texel is in the depth image; else it has no weight
};
// SPDX-License-Identifier: MIT
// Directions that divide the circle evenly, marched in even steps; both start at a random offset per pixel:
// stochastic-depth-ao, Algorithms 2 and 3.

vec2 crease_noise(ivec2 pixel);

struct crease_pattern {
    vec2 direction; // unit, on the disk that faces the eye
    vec2 stride;    // texels
    vec2 first;     // texels, of step 0; rounded down it is the texel
    float offset;   // of step 0, in strides
    float nearest;  // strides that make a texel, in the root mean square over the directions on the screen
};

float crease_directions_angle() { return 6.28318531 / float(crease_directions_count); }

crease_pattern crease_pattern_begin(crease_receiver receiver) {
    vec2 noise = crease_noise(receiver.pixel);
    float angle = noise.x * crease_directions_angle();
    // In each direction more than 1 / sqrt(2) of the texels that it says, so no tap falls on the receiver itself.
    float texels = abs(determinant(receiver.disk)) *
        inversesqrt(0.5 * (dot(receiver.disk[0], receiver.disk[0]) + dot(receiver.disk[1], receiver.disk[1])));
    return crease_pattern(vec2(cos(angle), sin(angle)), vec2(0.0), vec2(0.0), noise.y,
                          float(crease_directions_steps + 1) / texels);
}

int crease_direction_count() { return crease_directions_count; }

int crease_step_count() { return crease_directions_steps; }

vec2 crease_pattern_turn(inout crease_pattern pattern, crease_receiver receiver, int direction) {
    vec2 turn = vec2(cos(crease_directions_angle()), sin(crease_directions_angle()));
    // Of an even count each other one is the opposite of that before it, with which it shares much of its weighing.
    bool opposite = crease_directions_count % 2 == 0 && direction % 2 == 1;
    pattern.direction = opposite ? -pattern.direction
                                 : vec2(turn.x * pattern.direction.x - turn.y * pattern.direction.y,
                                        turn.y * pattern.direction.x + turn.x * pattern.direction.y);
    pattern.offset = fract(pattern.offset + 0.61803399); // another first step in each direction
    pattern.stride = receiver.disk * (pattern.direction * (1.0 / float(crease_directions_steps + 1)));
    pattern.first = receiver.texel + 0.5 + pattern.stride * (pattern.offset + pattern.nearest);
    return pattern.direction;
}

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    vec2 texel = floor(pattern.first + pattern.stride * float(step));
    return crease_tap(texel, crease_inside(texel));
}
// SPDX-License-Identifier: MIT
// Horizons: stochastic-depth-ao, Algorithm 2, with the threshold of 4.4.
//
// The Z axis of the paper's figure 4.5 is the direction to the eye. The angle of a tap is the tangent's plus its angle
// over the tangent plane, which is measured at the tap's own azimuth, as its texel moves it off the marched direction:
// so a plane is unoccluded at every slant.

int crease_direction_count();

struct crease_estimate {
    float occlusion;   // summed over the directions
    float horizon;     // of this direction: sine of its angle
    float sin_tangent; // of this direction
    float cos_tangent;
    float steepness;   // 1 / length of the normal's part in the plane of this direction and the eye
    vec2 lean;         // slope of the tangent plane along the axes of the disk
    float averted;     // 1 / cosine of the angle between the normal and the direction to the eye
    vec2 bias;         // cosine and sine of the bias
    float reach;       // 1 / square of the radius
};

struct crease_contribution {
    float occlusion;
    float horizon;
};

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    float averted = 1.0 / max(dot(receiver.normal, receiver.to_eye), 1e-3);
    vec2 lean = -averted * vec2(dot(receiver.normal, receiver.across), dot(receiver.normal, receiver.up));
    return crease_estimate(0.0, 0.0, 0.0, 0.0, 0.0, lean, averted, vec2(cos(crease_bias), sin(crease_bias)),
                           1.0 / (crease_radius * crease_radius));
}

void crease_estimate_turn(inout crease_estimate estimate, vec2 direction) {
    float slope = dot(estimate.lean, direction);
    estimate.cos_tangent = inversesqrt(1.0 + slope * slope);
    estimate.sin_tangent = slope * estimate.cos_tangent;
    estimate.steepness = estimate.cos_tangent * estimate.averted;
    // The tangent's angle plus the bias, at most a right angle.
    estimate.horizon = estimate.cos_tangent * estimate.bias.x < estimate.sin_tangent * estimate.bias.y
        ? 1.0
        : estimate.sin_tangent * estimate.bias.x + estimate.cos_tangent * estimate.bias.y;
}

// Sine of the angle of a tap, of the square of its distance and its height over the tangent plane.
float crease_hbao_sine(crease_estimate estimate, float squared, float height) {
    // The tap's parts across and along the tangent plane, turned by the tangent's angle.
    float away = sqrt(squared);
    float across = height * estimate.steepness;
    across = across < away ? across : away; // min() is more work for some drivers, which see to NaN in it
    float along = sqrt(max(squared - across * across, 0.0));
    return (estimate.cos_tangent * across + estimate.sin_tangent * along) / away;
}

crease_contribution crease_weigh(crease_estimate estimate, crease_receiver receiver, crease_tap tap, vec3 position) {
    vec3 to_tap = position - receiver.position;
    float squared = dot(to_tap, to_tap);
    float height = dot(to_tap, receiver.normal);
    float sine = crease_hbao_sine(estimate, squared, height);
    float falloff = 1.0 - squared * estimate.reach;
    bool counts =
        tap.inside && sine > estimate.horizon && falloff > 0.0 && height > crease_threshold * sqrt(squared);
    return counts ? crease_contribution(falloff * (sine - estimate.horizon), sine)
                  : crease_contribution(0.0, estimate.horizon);
}

void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution) {
    estimate.occlusion += contribution.occlusion;
    estimate.horizon = contribution.horizon;
}

float crease_estimate_occlusion(crease_estimate estimate) {
    return estimate.occlusion / float(crease_direction_count());
}
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
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, crease_size(crease_divisor)))) {
        crease_result result = crease_evaluate(pixel);
        crease_write(pixel, result)
    }
}
