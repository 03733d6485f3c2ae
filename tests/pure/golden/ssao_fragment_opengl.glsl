// hemisphere_points:16/single_layer/ssao/orthographic/reconstructed_normals/fragment/opengl, pass visibility; crease 0.2.0, SPDX-License-Identifier: MIT-0
#version 430
#define crease_unroll
const int crease_hemisphere_points_count = 16;
const int crease_divisor = 1;
const int crease_view_index = 0;
layout(binding = 0) uniform sampler2D crease_depth;
layout(location = 0) out vec4 crease_output;

struct crease_view_parameters {
    vec4 from_texel;
    vec2 depth_unpack;
    float far_depth;
    float guard;
    vec2 resolution;
    vec2 texel_size;
};

layout(std140, binding = 0) uniform crease_parameters {
    crease_view_parameters views[1];
    float radius;
    uint frame;
    float ssao_bias;
    float strength;
    float exponent;
} crease_given;

float crease_radius = crease_given.radius;
uint crease_frame = crease_given.frame;
float crease_ssao_bias = crease_given.ssao_bias;
float crease_strength = crease_given.strength;
float crease_exponent = crease_given.exponent;

#define crease_write(pixel, result) crease_output = crease_encode_visibility(result);

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

// An orthographic projection, centred or not; depth standard or reversed.
float crease_linear_depth(float device) {
    float depth = device * crease_view.depth_unpack.x + crease_view.depth_unpack.y;
    return depth < crease_view.far_depth ? depth : crease_background; // the far plane occludes nothing
}

// The depth image holds device depth, as the depth buffer does.
float crease_depth_at(vec2 texel) {
    return crease_linear_depth(textureLod(crease_depth, (texel + 0.5) * crease_view.texel_size, 0.0).x);
}

crease_result crease_open_result() { return crease_result(1.0, crease_background, vec3(0.0, 0.0, 1.0)); }

vec3 crease_view_position(vec2 texel, float depth) {
    return vec3(texel * crease_view.from_texel.xy + crease_view.from_texel.zw, -depth);
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

// Range-checked points: stochastic-depth-ao, Algorithm 1. Geometry further than the radius is ignored, as 4.1 says; the
// listing's smoothstep of R / |p.z - d| would leave half of it there at two radii. What hides a point from the eye and
// is out of range says nothing of it.
struct crease_estimate {
    float occluded; // points
    float points;
};

// What the directions of a receiver sum up to.
struct crease_gathered {
    crease_estimate estimate;
};

// Visibility by strength and exponent: stochastic-depth-ao 8.1.
float crease_visibility_of(float occlusion) {
    return pow(clamp(1.0 - occlusion * crease_strength, 0.0, 1.0), crease_exponent);
}

float crease_estimate_occlusion(crease_estimate estimate) { return estimate.occluded / max(estimate.points, 1.0); }

crease_result crease_conclude(crease_gathered gathered, crease_receiver receiver) {
    return crease_result(crease_visibility_of(crease_estimate_occlusion(gathered.estimate)), -receiver.position.z,
                         receiver.normal);
}

// Points in the hemisphere over the receiver, turned about the normal by a random angle per pixel:
// stochastic-depth-ao 4.1. Directions are distributed by the cosine and distances evenly, so that the share of points
// behind a surface at distance d is the cosine-weighted occlusion with a linear falloff, 1 - d / R.
struct crease_pattern {
    vec3 tangent, bitangent; // view space, unit
    vec2 direction;          // unit, in the tangent plane
    float radius;            // view space
    float distance;          // in radii
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

// From offsets on the disk that faces the eye, in AO radii, to texels; naga reads no struct that holds a matrix.
mat2 crease_disk_of(crease_receiver receiver) { return mat2(receiver.disk_x, receiver.disk_y); }

// Size of the depth image in texels, guard band included.
vec2 crease_depth_size() { return crease_view.resolution + 2.0 * crease_view.guard; }

// The radius in which a sampler looks for points: no larger than half the picture's diagonal at the receiver's depth,
// so that a radius that is larger than the picture still finds what is there.
float crease_radius_inside(crease_receiver receiver) {
    float texels = sqrt(abs(determinant(crease_disk_of(receiver)))); // of the radius
    return crease_radius * min(1.0, 0.5 * length(crease_depth_size()) / texels);
}

crease_pattern crease_pattern_begin(crease_receiver receiver) {
    vec2 noise = crease_noise(receiver.pixel).xy;
    vec3 normal = receiver.normal;
    vec3 axis = abs(normal.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    vec3 tangent = normalize(cross(axis, normal));
    float angle = 6.28318531 * noise.x;
    return crease_pattern(tangent, cross(normal, tangent), vec2(cos(angle), sin(angle)),
                          crease_radius_inside(receiver), noise.y);
}

crease_estimate crease_estimate_begin(crease_receiver receiver) { return crease_estimate(0.0, 0.0); }

crease_gathered crease_begin_gathering(crease_receiver receiver) {
    return crease_gathered(crease_estimate_begin(receiver));
}

int crease_direction_count() { return 1; }

int crease_step_count() { return crease_hemisphere_points_count; }

const int crease_most_layers = 1;

// Unroll fully up to this many layer fetches; otherwise unroll one direction if it fits.
const int crease_most_unrolled = 128;

vec2 crease_pattern_direction(inout crease_pattern pattern, crease_receiver receiver, int direction) { return vec2(0.0); }

struct crease_march {
    float occluded;
    float points;
    vec3 open;      // directions of the points, weighed by how open they are
    float openness; // sum of these weights
    float rounding; // of depth
};

// How far rounding of the depth buffer, and of what is made of it, may bring two depths of one surface apart.
float crease_depth_rounding(float depth) { return 1.8e-7 * (depth + abs(depth - crease_view.depth_unpack.y)); }

crease_march crease_begin_direction(crease_estimate estimate, crease_receiver receiver, vec2 direction) {
    return crease_march(0.0, 0.0, vec3(0.0), 0.0, crease_depth_rounding(-receiver.position.z));
}
const int crease_batch_size = 4;

// A tap at a point of view space, moved onto the ray through the centre of the texel that it falls into.
struct crease_tap {
    vec2 texel;
    bool inside; // whether the texel is in the depth image; else it has no weight
    vec3 offset; // from the receiver, view space
};

// One layer, the depth image's.
struct crease_layers {
    vec2 texel;
    float depth;
};

struct crease_fetched {
    crease_layers layers;
};

vec2 crease_texel_at(vec3 position) {
    return (position.xy - crease_view.from_texel.zw) / crease_view.from_texel.xy;
}

// The ray of a texel by the receiver: start + t * ray from it, where t counts depth and is 0 where the receiver is.
// Differences are of rays alone, as those of positions keep nothing of a radius that is small beside the distance.
void crease_texel_ray(crease_receiver receiver, vec2 texel, out vec3 start, out vec3 ray) {
    vec3 eye = crease_view_position(texel, 0.0), own_eye = crease_view_position(receiver.texel, 0.0);
    vec3 own_ray = crease_view_position(receiver.texel, 1.0) - own_eye;
    ray = crease_view_position(texel, 1.0) - eye;
    start = (eye - own_eye) - (ray - own_ray) * receiver.position.z;
}

// Whether texel coordinates lie inside the depth image. Compares bits: those of negative numbers and NaN exceed any size's.
bool crease_inside(vec2 texel) {
    return all(lessThan(floatBitsToUint(texel), floatBitsToUint(crease_depth_size())));
}

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
    // A point that moving to its texel took out of the hemisphere is left out; so a plane is unoccluded at every slant.
    bool above = dot(moved, receiver.normal) > 0.0;
    return crease_tap(texel, above && point.z < 0.0 && crease_inside(texel), moved);
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
    float points;
    vec3 open;
    float openness;
};

void crease_add(inout crease_march march, crease_contribution contribution) {
    march.occluded += contribution.occlusion;
    march.points += contribution.points;
    march.open += contribution.open;
    march.openness += contribution.openness;
}

// A surface at a texel.
struct crease_layer {
    vec3 position; // view space
    float texels;  // it stands for: 1, or the number of texels of an area
};

// The height over the tangent plane up to which a point is left out, as rounding may put it on either side of the
// surface: a share of the radius, or of the depth where the radius is larger.
float crease_point_bias(crease_receiver receiver, float bias) {
    return bias * min(crease_radius, -receiver.position.z);
}

// How open the direction to a point is goes into the bent normal: stochastic-depth-ao 7.1, Algorithm 10.
crease_contribution crease_ssao_contribution(crease_tap tap, float occlusion, float points, float openness) {
    vec3 open = tap.offset * (openness * inversesqrt(max(dot(tap.offset, tap.offset), 1e-30)));
    return crease_contribution(occlusion, points, open, openness);
}

// How much nearer to the eye a layer is than the receiver, in depth.
float crease_layer_before(crease_receiver receiver, crease_layer layer) {
    return layer.position.z - receiver.position.z;
}

// 1, or -1 where the receiver is looked at from behind.
float crease_eye_side(crease_receiver receiver) { return 1.0; }

crease_contribution crease_weigh(crease_march march, crease_receiver receiver, crease_tap tap, crease_layer layer) {
    // A point close to the tangent plane says nothing. One beside the picture counts as open for the bent normal, as
    // leaving it out would turn the cone to the picture's middle.
    if (dot(tap.offset, receiver.normal) <= crease_point_bias(receiver, crease_ssao_bias))
        return crease_ssao_contribution(tap, 0.0, 0.0, 0.0);
    if (!tap.inside)
        return crease_ssao_contribution(tap, 0.0, 0.0, 1.0);
    float before = crease_layer_before(receiver, layer);
    // Of layers that do not occlude, the tiny negative numbers make one behind the point win over one that is out of
    // range, and either over background, where layers are combined by the greater occlusion.
    if (before - march.rounding < crease_eye_side(receiver) * tap.offset.z) {
        float nothing = layer.position.z > -0.5 * crease_background ? 0.0 : -2e-6;
        return crease_ssao_contribution(tap, nothing, 1.0, 1.0 - nothing);
    }
    float in_range = smoothstep(0.0, 1.0, 2.0 * (1.0 - before / crease_radius));
    float occlusion = in_range > 0.0 ? in_range : -1e-6;
    return crease_ssao_contribution(tap, occlusion, in_range, in_range - occlusion);
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
    estimate.occluded += march.occluded;
    estimate.points += march.points;
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

vec3 crease_to_eye(vec3 position) { return vec3(0.0, 0.0, 1.0); }

void crease_axes(vec3 to_eye, out vec3 tangent, out vec3 bitangent) {
    tangent = vec3(1.0, 0.0, 0.0);
    bitangent = vec3(0.0, 1.0, 0.0);
}

mat2 crease_disk(vec3 position, vec3 tangent, vec3 bitangent) {
    vec2 scale = crease_radius / crease_view.from_texel.xy;
    return mat2(scale.x, 0.0, 0.0, scale.y);
}

crease_receiver crease_make_receiver(ivec2 pixel, vec2 texel, vec3 position, vec3 normal) {
    vec3 to_eye = crease_to_eye(position), tangent, bitangent;
    crease_axes(to_eye, tangent, bitangent);
    mat2 disk = crease_disk(position, tangent, bitangent);
    return crease_receiver(pixel, texel, position, normal, to_eye, tangent, bitangent, disk[0], disk[1]);
}

// The normal of the plane through the receiver and two neighbours: of left and right, and of up and down, the one that
// is nearer in depth.
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

// Of the surface in the depth image; background is open.
crease_result crease_evaluate(ivec2 pixel) {
    vec2 texel = crease_texel_of_pixel(pixel, crease_divisor);
    float depth = crease_depth_at(texel);
    if (!(depth > 0.0 && depth < crease_background))
        return crease_open_result();
    vec3 position = crease_view_position(texel, depth);
    return crease_result_of(crease_make_receiver(pixel, texel, position, crease_normal_at(texel, position)));
}

// Visibility alone.
vec4 crease_encode_visibility(crease_result result) { return vec4(result.visibility); }

void main() {
    crease_result result = crease_evaluate(ivec2(gl_FragCoord.xy));
    crease_write(pixel, result)
}
