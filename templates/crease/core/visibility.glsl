#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// The loop of every technique: each tap of the sampler, each layer of the depth source, weighed by the estimator.

float crease_depth_at(vec2 texel);
vec3 crease_view_position(vec2 texel, float depth);
vec3 crease_to_eye(vec3 position);
void crease_axes(vec3 to_eye, out vec3 across, out vec3 up);
mat2 crease_disk(vec3 position, vec3 across, vec3 up);
vec3 crease_normal_at(vec2 texel, vec3 position);
crease_pattern crease_pattern_begin(crease_receiver receiver);
int crease_direction_count();
int crease_step_count();
vec2 crease_pattern_turn(inout crease_pattern pattern, crease_receiver receiver, int direction);
crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step);
crease_estimate crease_estimate_begin(crease_receiver receiver);
void crease_estimate_turn(inout crease_estimate estimate, vec2 direction);
crease_layers crease_fetch_layers(vec2 texel);
crease_contribution crease_fold(crease_estimate estimate, crease_receiver receiver, crease_tap tap,
                                crease_layers layers);
void crease_estimate_add(inout crease_estimate estimate, crease_contribution contribution);
float crease_estimate_occlusion(crease_estimate estimate);

const int crease_batch = 4; // taps whose layers are fetched before any is weighed, so that the waits overlap

void crease_take(inout crease_estimate estimate, inout crease_pattern pattern, crease_receiver receiver, int first,
                 int count) {
    crease_tap taps[crease_batch];
    crease_layers layers[crease_batch];
    for (int i = 0; i < count; ++i) {
        taps[i] = crease_pattern_tap(pattern, receiver, first + i);
        layers[i] = crease_fetch_layers(taps[i].inside ? taps[i].texel : receiver.texel);
    }
    for (int i = 0; i < count; ++i) {
        crease_contribution contribution = crease_fold(estimate, receiver, taps[i], layers[i]);
        if (taps[i].inside)
            crease_estimate_add(estimate, contribution);
    }
}

crease_result crease_evaluate(ivec2 pixel) {
    crease_receiver receiver;
    receiver.pixel = pixel;
    receiver.texel = crease_texel_of_pixel(pixel, crease_divisor);
    float depth = crease_depth_at(receiver.texel);
    if (!(depth > 0.0 && depth < crease_background))
        return crease_result(1.0, crease_background);
    receiver.position = crease_view_position(receiver.texel, depth);
    receiver.to_eye = crease_to_eye(receiver.position);
    crease_axes(receiver.to_eye, receiver.across, receiver.up);
    receiver.disk = crease_disk(receiver.position, receiver.across, receiver.up);
    receiver.normal = crease_normal_at(receiver.texel, receiver.position);

    crease_pattern pattern = crease_pattern_begin(receiver);
    crease_estimate estimate = crease_estimate_begin(receiver);
    for (int direction = 0; direction < crease_direction_count(); ++direction) {
        crease_estimate_turn(estimate, crease_pattern_turn(pattern, receiver, direction));
        int rest = crease_step_count() % crease_batch, whole = crease_step_count() - rest;
        for (int step = 0; step < whole; step += crease_batch)
            crease_take(estimate, pattern, receiver, step, crease_batch);
        crease_take(estimate, pattern, receiver, whole, rest);
    }
    float occlusion = crease_estimate_occlusion(estimate);
    // Strength and exponent: stochastic-depth-ao 8.1.
    return crease_result(pow(clamp(1.0 - occlusion * crease_strength, 0.0, 1.0), crease_exponent), depth);
}
#ifdef __cplusplus
")glsl"
#endif
