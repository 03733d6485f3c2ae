// poisson_disk:16/single_layer/hbao_plus/linear_depth/functions:1x4x10, pass visibility; crease 0.2.0, SPDX-License-Identifier: MIT-0
#define crease_unroll
layout(constant_id = 10) const int crease_poisson_disk_count = 16;
const int crease_divisor = 1;
const int crease_view_index = 0;
layout(set = 1, binding = 5) uniform sampler2D crease_depth;
layout(set = 1, binding = 6) uniform sampler2D crease_normal;

struct crease_view_parameters {
    vec4 from_texel;
    vec2 depth_unpack;
    float far_depth;
    float guard;
    vec2 resolution;
    vec2 texel_size;
};

layout(std140, set = 1, binding = 4) uniform crease_parameters {
    crease_view_parameters views[1];
    float radius;
    uint frame;
    float hbao_plus_bias;
    float strength;
    float exponent;
} crease_given;

float crease_radius = crease_given.radius;
uint crease_frame = crease_given.frame;
float crease_hbao_plus_bias = crease_given.hbao_plus_bias;
float crease_strength = crease_given.strength;
float crease_exponent = crease_given.exponent;

// What a pass computes for a pixel.
struct crease_result {
    float visibility; // 1 open, 0 closed
    float depth;      // positive, linear; crease_background where there is none
    vec3 normal;      // view space, unit; filters that weigh by it have it handed on
};

// Shaders index texels of the whole depth image, guard band included, with texel centres at whole numbers.
crease_view_parameters crease_view_of(int index) {
    crease_view_parameters view = crease_given.views[index];
    view.from_texel.zw += (0.5 - view.guard) * view.from_texel.xy;
    return view;
}

// A copy, as some compilers reload uniforms in every iteration.
crease_view_parameters crease_view = crease_view_of(crease_view_index); // of the camera at work

// The depth texel of a pixel at 1 / divisor of the resolution.
vec2 crease_texel_of_pixel(ivec2 pixel, int divisor) {
    return vec2(min(pixel * divisor + (divisor - 1) / 2, ivec2(crease_view.resolution) - 1)) + crease_view.guard;
}

// The depth of background: beyond any radius, and finite, so that its square is finite too.
const float crease_background = 1e15;

// The depth image holds positive linear view depth.
float crease_depth_at(vec2 texel) {
    float depth = textureLod(crease_depth, (texel + 0.5) * crease_view.texel_size, 0.0).x;
    return depth > 0.0 && depth < crease_view.far_depth ? depth : crease_background; // 0 is a hole, not a surface at the eye
}

crease_result crease_open_result() { return crease_result(1.0, crease_background, vec3(0.0, 0.0, 1.0)); }

vec3 crease_view_position(vec2 texel, float depth) {
    return vec3((texel * crease_view.from_texel.xy + crease_view.from_texel.zw) * depth, -depth);
}

// The point whose visibility is asked for.
struct crease_receiver {
    ivec2 pixel;             // of the pass's output
    vec2 texel;              // texel space of the depth image
    vec3 position;           // view space
    vec3 normal;             // view space, unit
    vec3 to_eye;             // view space, unit
    vec3 tangent, bitangent; // view space, unit: the axes of the disk that faces the eye
    vec2 disk_x, disk_y;     // texels that an AO radius along these axes takes
};

// Taps projected onto the normal: stochastic-depth-ao, Algorithm 3.
struct crease_estimate {
    float occlusion; // summed over the taps
    float weights;
    float reach;     // 1 / square of the radius
};

// What the directions of a receiver sum up to.
struct crease_gathered {
    crease_estimate estimate;
};

// Visibility by strength and exponent: stochastic-depth-ao 8.1.
float crease_visibility_of(float occlusion) {
    return pow(clamp(1.0 - occlusion * crease_strength, 0.0, 1.0), crease_exponent);
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.occlusion / max(estimate.weights, 1e-20); }

crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver) {
    return crease_result(crease_visibility_of(crease_estimate_occlusion(gathered.estimate)), -receiver.position.z,
                         receiver.normal);
}

// Points spread evenly over the disk of the radius: a spiral of golden angles, on which no two of N points are nearer to
// each other than 1 / sqrt(N) of the radius, for every N. It is turned, and its radii are shifted, at random per pixel.
struct crease_pattern {
    vec2 direction; // unit, on the disk that faces the eye
    float offset;   // of the first radius
};

// Three numbers in [0, 1) that differ from pixel to pixel and from frame to frame.
uvec3 crease_hashed_noise_mix(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v += v.yzx * v.zxy;
    v ^= v >> 16u;
    v += v.yzx * v.zxy;
    return v;
}

vec3 crease_noise(ivec2 pixel) {
    return vec3(crease_hashed_noise_mix(uvec3(uvec2(pixel), crease_frame)) >> 8u) * (1.0 / 16777216.0);
}

crease_pattern crease_pattern_begin(crease_receiver receiver) {
    vec2 noise = crease_noise(receiver.pixel).xy;
    float angle = 6.28318531 * noise.x;
    return crease_pattern(vec2(cos(angle), sin(angle)), noise.y);
}

crease_estimate crease_estimate_begin(crease_receiver receiver) {
    return crease_estimate(0.0, 0.0, 1.0 / (crease_radius * crease_radius));
}

crease_gathered crease_begin_gathering(crease_receiver receiver) {
    return crease_gathered(crease_estimate_begin(receiver));
}

int crease_direction_count() { return 1; }

// A disk of points that keep apart.
int crease_step_count() { return crease_poisson_disk_count; }

const int crease_most_layers = 1;

// Unroll fully up to this many layer fetches; otherwise unroll one direction if it fits.
const int crease_most_unrolled = 128;

vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) { return vec2(0.0); }

// A direction.
struct crease_march {
    float occlusion;
    float weights;
    float highest; // cosine between the normal and the way to a layer less the bias, where that occludes
    float reach;
};

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    return crease_march(0.0, 0.0, 0.0, estimate.reach);
}
const int crease_batch_size = 4;

// A tap on the screen, at the centre of a texel.
struct crease_tap {
    vec2 texel;
    bool inside;  // whether the texel is in the depth image; else it has no weight
    float weight; // of the tap among those of the receiver, in a mean over the distances or the area around it
};

// One layer, the depth image's.
struct crease_layers {
    vec2 texel;
    float depth;
};

struct crease_fetched {
    crease_layers layers;
};

// From offsets on the disk that faces the eye, in AO radii, to texels; naga reads no struct that holds a matrix.
mat2 crease_disk_of(crease_receiver receiver) { return mat2(receiver.disk_x, receiver.disk_y); }

// Size of the depth image in texels, guard band included.
vec2 crease_depth_size() { return crease_view.resolution + 2.0 * crease_view.guard; }

// How much of a way across the depth image stays in it, from 0 to 1: a march is cut at the picture's edge, so that a
// radius that is larger than the picture still finds what is there. `from` and `way` in texels, edges being whole
// numbers.
float crease_share_inside(vec2 from, vec2 way) {
    vec2 after = crease_depth_size() - from;
    vec2 share = vec2(way.x < 0.0 ? from.x : after.x, way.y < 0.0 ? from.y : after.y) * abs(1.0 / way);
    return clamp(min(share.x, share.y), 0.0, 1.0);
}

// The texel of the next point, and the share of the disk in its direction that is in the depth image.
vec2 crease_disk_texel(inout crease_pattern pattern, crease_receiver receiver, int step, out float share) {
    const vec2 golden_angle = vec2(-0.73736888, 0.67549029);
    pattern.direction = vec2(golden_angle.x * pattern.direction.x - golden_angle.y * pattern.direction.y,
                             golden_angle.y * pattern.direction.x + golden_angle.x * pattern.direction.y);
    float distance = sqrt((float(step) + pattern.offset) / float(crease_step_count()));
    vec2 radius = crease_disk_of(receiver) * pattern.direction;
    share = crease_share_inside(receiver.texel + 0.5, radius);
    return floor(receiver.texel + 0.5 + radius * (share * distance));
}

// Whether texel coordinates lie inside the depth image. Compares bits: those of negative numbers and NaN exceed any size's.
bool crease_inside(vec2 texel) {
    return all(lessThan(floatBitsToUint(texel), floatBitsToUint(crease_depth_size())));
}

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    float share;
    vec2 texel = crease_disk_texel(pattern, receiver, step, share);
    return crease_tap(texel, texel != receiver.texel && crease_inside(texel), share * share);
}

crease_layers crease_fetch_layers(vec2 texel) { return crease_layers(texel, crease_depth_at(texel)); }

// Fetches the layers that are worth fetching before any is weighed: by default all.
crease_layers crease_fetch_first_layers(vec2 texel) { return crease_fetch_layers(texel); }

crease_fetched crease_fetch(vec2 texel) { return crease_fetched(crease_fetch_first_layers(texel)); }

// A source that holds several sizes of texels chooses among them here, and moves the tap to the one it takes.
crease_fetched crease_fetch_tap(crease_pattern pattern, crease_receiver receiver, int step, inout crease_tap tap) {
    return crease_fetch(tap.texel);
}

struct crease_contribution {
    float occlusion;
    float highest;
    float weight;
};

void crease_add(inout crease_march march, crease_contribution contribution) {
    march.occlusion += contribution.occlusion;
    march.weights += contribution.weight;
    march.highest = max(march.highest, contribution.highest);
}

// A surface at a texel.
struct crease_layer {
    vec3 position; // view space
    float texels;  // it stands for: 1, or the number of texels of an area
};

crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    vec3 to_layer = layer.position - receiver.position;
    float squared = dot(to_layer, to_layer);
    float rise = dot(to_layer, receiver.normal) * inversesqrt(squared) - crease_hbao_plus_bias;
    float falloff = 1.0 - squared * march.reach;
    bool counts = tap.inside && falloff > 0.0 && rise > 0.0;
    float weight = tap.inside ? tap.weight : 0.0;
    return crease_contribution(counts ? weight * falloff * rise : 0.0, counts ? rise : 0.0, weight);
}

crease_layer crease_layer_at(crease_layers layers, int i) {
    return crease_layer(crease_view_position(layers.texel, layers.depth), 1.0);
}

crease_contribution crease_combine_first_layers(crease_march march, crease_receiver receiver, crease_tap tap,
                                                crease_layers layers) {
    return crease_weigh(march, receiver, tap, crease_layer_at(layers, 0));
}

void crease_traverse(inout crease_march march, crease_receiver receiver, crease_tap tap, crease_fetched fetched) {
    crease_add(march, crease_combine_first_layers(march, receiver, tap, fetched.layers));
}

// Fetches a batch of taps before any is weighed, so that their latencies overlap.
void crease_gather_taps(inout crease_march march, inout crease_pattern pattern, crease_receiver receiver, int first) {
    crease_tap taps[crease_batch_size];
    crease_fetched fetched[crease_batch_size];
    int count = crease_step_count() % crease_batch_size == 0 ? crease_batch_size : crease_step_count() - first;
    crease_unroll for (int i = 0; i < crease_batch_size; ++i)
        if (i < count) {
            taps[i] = crease_pattern_tap(pattern, receiver, first + i);
            fetched[i] = crease_fetch_tap(pattern, receiver, first + i, taps[i]);
        }
    crease_unroll for (int i = 0; i < crease_batch_size; ++i)
        if (i < count)
            crease_traverse(march, receiver, taps[i], fetched[i]);
}

void crease_end_direction(inout crease_estimate estimate, crease_march march) {
    estimate.occlusion += march.occlusion;
    estimate.weights += march.weights;
}

void crease_close_direction(inout crease_gathered gathered, crease_march march, crease_receiver receiver,
                            vec2 direction) {
    crease_end_direction(gathered.estimate, march);
}

void crease_gather_direction(inout crease_gathered gathered, inout crease_pattern pattern, crease_receiver receiver,
                             int i) {
    vec2 direction = crease_pattern_direction(pattern, receiver, i);
    crease_march march = crease_begin_direction(gathered.estimate, receiver, direction);
    if (crease_step_count() * crease_most_layers <= crease_most_unrolled) {
        crease_unroll for (int step = 0; step < crease_step_count(); step += crease_batch_size)
            crease_gather_taps(march, pattern, receiver, step);
    } else {
        for (int step = 0; step < crease_step_count(); step += crease_batch_size)
            crease_gather_taps(march, pattern, receiver, step);
    }
    crease_close_direction(gathered, march, receiver, direction);
}

// Every technique: for each direction and tap of the sampler, each layer of the depth source, weighed by the estimator.
crease_gathered crease_gather(crease_receiver receiver) {
    crease_pattern pattern = crease_pattern_begin(receiver);
    crease_gathered gathered = crease_begin_gathering(receiver);
    if (crease_direction_count() * crease_step_count() * crease_most_layers <= crease_most_unrolled) {
        crease_unroll for (int i = 0; i < crease_direction_count(); ++i)
            crease_gather_direction(gathered, pattern, receiver, i);
    } else {
        for (int i = 0; i < crease_direction_count(); ++i)
            crease_gather_direction(gathered, pattern, receiver, i);
    }
    return gathered;
}

crease_result crease_result_of(crease_receiver receiver) {
    return crease_conclude(crease_gather(receiver), receiver);
}

vec3 crease_to_eye(vec3 position) { return -normalize(position); }

void crease_axes(vec3 to_eye, out vec3 tangent, out vec3 bitangent) {
    tangent = normalize(vec3(to_eye.z, 0.0, -to_eye.x));
    bitangent = cross(to_eye, tangent);
}

// Derivative of the projection at `position` along two axes that face the eye, times the radius.
mat2 crease_disk(vec3 position, vec3 tangent, vec3 bitangent) {
    vec2 ray = position.xy / -position.z;
    vec2 scale = crease_radius / (-position.z * crease_view.from_texel.xy);
    return mat2((tangent.xy + ray * tangent.z) * scale, (bitangent.xy + ray * bitangent.z) * scale);
}

crease_receiver crease_make_receiver(ivec2 pixel, vec2 texel, vec3 position, vec3 normal) {
    vec3 to_eye = crease_to_eye(position), tangent, bitangent;
    crease_axes(to_eye, tangent, bitangent);
    mat2 disk = crease_disk(position, tangent, bitangent);
    return crease_receiver(pixel, texel, position, normal, to_eye, tangent, bitangent, disk[0], disk[1]);
}

// A normal of any length as one of unit length; what has no direction counts as facing the eye.
vec3 crease_unit_normal(vec3 normal, vec3 position) {
    float squared = dot(normal, normal);
    return squared > 0.0 && squared < 1.0e30 ? normal * inversesqrt(squared) : crease_to_eye(position);
}

// The image holds normals as they are.
vec3 crease_stored_normal(vec2 texel) {
    return textureLod(crease_normal, (texel + 0.5) * crease_view.texel_size, 0.0).xyz;
}

vec3 crease_normal_at(vec2 texel, vec3 position) {
    return crease_unit_normal(crease_stored_normal(texel), position);
}

// Of the surface in the depth image; background is open.
crease_result crease_evaluate(ivec2 pixel) {
    vec2 texel = crease_texel_of_pixel(pixel, crease_divisor);
    float depth = crease_depth_at(texel);
    if (!(depth > 0.0 && depth < crease_background))
        return crease_open_result();
    vec3 position = crease_view_position(texel, depth);
    return crease_result_of(crease_make_receiver(pixel, texel, position, crease_normal_at(texel, position)));
}

// Visibility of a pixel of the pass's output: 1 open, 0 closed.
float crease_visibility(ivec2 pixel) {
    return crease_evaluate(pixel).visibility;
}
