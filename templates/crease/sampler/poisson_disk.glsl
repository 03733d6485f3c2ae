#ifdef __cplusplus
R"glsl("
#endif
// SPDX-License-Identifier: MIT
// A Poisson disk of at most 64 points, any first N of which are spread evenly; turned by a random angle per pixel.

vec2 crease_noise(ivec2 pixel);

struct crease_pattern {
    mat2 disk; // of the receiver, turned
};

const vec2 crease_poisson_disk_points[64] = vec2[64](
    vec2(-0.176483, 0.520953), vec2(0.169239, -0.516320), vec2(0.622194, 0.209094),
    vec2(-0.603908, -0.194253), vec2(0.690252, -0.336823), vec2(0.065720, 0.023108),
    vec2(0.347951, 0.693116), vec2(-0.350735, -0.691143), vec2(-0.691693, 0.337772),
    vec2(-0.197111, -0.306208), vec2(-0.333756, 0.120518), vec2(0.508875, -0.671395),
    vec2(0.267939, 0.330911), vec2(-0.000162, -0.848113), vec2(0.003434, 0.850318),
    vec2(0.414780, -0.096617), vec2(-0.511317, 0.678727), vec2(0.658179, 0.550309),
    vec2(-0.660104, -0.550052), vec2(0.849818, -0.036424), vec2(-0.851747, 0.046343),
    vec2(-0.029978, 0.284930), vec2(0.095921, 0.578910), vec2(0.417086, -0.393570),
    vec2(-0.272515, 0.832870), vec2(0.285681, -0.837073), vec2(-0.422512, 0.395416),
    vec2(-0.099898, -0.570249), vec2(0.164991, -0.232415), vec2(-0.438597, -0.407842),
    vec2(-0.823011, -0.338522), vec2(-0.586452, 0.103849), vec2(0.828818, 0.349387),
    vec2(-0.361989, -0.117891), vec2(0.281814, 0.100959), vec2(0.484127, 0.405511),
    vec2(-0.142682, -0.063909), vec2(-0.705567, 0.566252), vec2(0.636567, -0.113340),
    vec2(0.714581, -0.560758), vec2(0.225018, 0.877038), vec2(-0.230757, -0.884113),
    vec2(-0.002985, -0.383042), vec2(0.877592, -0.252077), vec2(-0.553420, -0.725659),
    vec2(-0.239258, 0.304428), vec2(-0.880991, 0.251192), vec2(0.548025, 0.722171),
    vec2(-0.897723, -0.149855), vec2(0.902157, 0.161693), vec2(0.314760, -0.643572),
    vec2(-0.142099, 0.128722), vec2(0.480253, 0.081526), vec2(-0.113192, 0.701356),
    vec2(0.123715, -0.698741), vec2(-0.325091, 0.635956), vec2(-0.274391, -0.502667),
    vec2(0.297945, 0.514300), vec2(-0.014354, -0.192616), vec2(-0.625023, -0.373023),
    vec2(0.531911, -0.256446), vec2(-0.693255, -0.035064), vec2(0.240123, -0.069055),
    vec2(0.135515, 0.218560));

crease_pattern crease_pattern_begin(crease_receiver receiver) {
    float angle = 6.28318531 * crease_noise(receiver.pixel).x;
    float c = cos(angle), s = sin(angle);
    return crease_pattern(receiver.disk * mat2(c, s, -s, c));
}

int crease_direction_count() { return 1; }

int crease_step_count() { return crease_poisson_disk_count; }

void crease_pattern_turn(inout crease_pattern pattern, crease_receiver receiver, int direction) {}

crease_tap crease_pattern_tap(inout crease_pattern pattern, crease_receiver receiver, int step) {
    vec2 texel = floor(receiver.texel + pattern.disk * crease_poisson_disk_points[step]) + 0.5;
    bool itself = texel == receiver.texel;
    return crease_tap(texel, !itself && all(greaterThan(texel, vec2(0.0))) && all(lessThan(texel, crease_resolution)));
}
#ifdef __cplusplus
")glsl"
#endif
