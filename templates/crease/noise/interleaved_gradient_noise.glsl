// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// Interleaved gradient noise: Jimenez 2014, Next Generation Post Processing in Call of Duty: Advanced Warfare. Any 3 x 3
// pixels divide [0, 1) nearly evenly.
float crease_interleaved_gradient_noise_at(vec2 place) {
    return fract(52.9829189 * fract(dot(place, vec2(0.06711056, 0.00583715))));
}

// The second number is of the transposed picture and the third of one that is turned by a right angle, as their gradients
// would run along with the first's.
vec3 crease_noise(ivec2 pixel) {
    vec2 place = vec2(pixel) + 5.588238 * float(crease_frame % 64u);
    return vec3(crease_interleaved_gradient_noise_at(place),
                crease_interleaved_gradient_noise_at(place.yx + vec2(17.0, 47.0)),
                crease_interleaved_gradient_noise_at(vec2(-place.y, place.x) + vec2(38.0, 69.0)));
}
#ifdef __cplusplus
")glsl"
#endif
