// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
mat2 crease_disk_of(crease_receiver receiver);
#else
__LINE__, R"glsl("
#endif

// A march whose steps grow by a power of their index. It begins a texel away, so that no tap falls on the receiver
// itself; what would be beside the depth image is looked for at its edge.
struct crease_stepped_march {
    vec2 receiver; // its texel
    vec2 first;    // texels: where it begins; rounded down it is the texel
    vec2 radius;   // texels: the way to the radius
    vec2 ahead;    // texels: unit, across the line of the receiver on one side of which the half slice is
    float offset;  // of step 0, in steps
};

crease_stepped_march crease_stepped_march_begin(crease_receiver receiver, vec2 direction, float offset) {
    vec2 radius = crease_disk_of(receiver) * direction;
    vec2 texel = radius * inversesqrt(max(dot(radius, radius), 1e-20));
    vec2 line = crease_disk_of(receiver) * vec2(-direction.y, direction.x), ahead = vec2(line.y, -line.x);
    ahead *= inversesqrt(max(dot(line, line), 1e-20)) * sign(dot(ahead, radius));
    return crease_stepped_march(receiver.texel, receiver.texel + 0.5 + texel, radius, ahead,
                                max(offset, 1e-4)); // gaps are shares of it
}

crease_tap crease_stepped_tap(crease_stepped_march march, int step, int steps, int power) {
    float scale = 1.0 / float(steps);
    float along = float(step) * scale + march.offset * scale, density = 1.0;
    for (int i = 1; i < power; ++i)
        density *= along;
    float distance = density * along;
    vec2 texel = clamp(floor(march.first + march.radius * distance), vec2(0.0), crease_depth_size() - 1.0);
    bool inside = dot(texel - march.receiver, march.ahead) > 0.5; // else the edge has moved it out of the half slice
    return crease_tap(texel, inside, density, distance, float(power) * scale / along);
}

// Texels from a step to the next.
float crease_stepped_spacing(crease_stepped_march march, int step, int steps, int power) {
    float along = (float(step) + march.offset) / float(steps), spacing = float(power) / float(steps);
    for (int i = 1; i < power; ++i)
        spacing *= along;
    return spacing * length(march.radius);
}
#ifdef __cplusplus
")glsl"
#endif
