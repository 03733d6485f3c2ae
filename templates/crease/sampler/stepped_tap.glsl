// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// A march whose steps grow by a power of their index. It begins a texel away, so that no tap falls on the receiver
// itself; what would be beside the depth image is looked for at its edge.
struct crease_stepped_march {
    vec2 receiver; // its texel
    vec2 first;    // texels: where it begins; rounded down it is the texel
    vec2 radius;   // texels: the way to the radius
    float offset;  // of step 0, in steps
};

crease_stepped_march crease_stepped_march_begin(crease_receiver receiver, vec2 direction, float offset) {
    vec2 radius = receiver.disk * direction;
    vec2 texel = radius * inversesqrt(max(dot(radius, radius), 1e-20));
    return crease_stepped_march(receiver.texel, receiver.texel + 0.5 + texel, radius,
                                max(offset, 1e-4)); // gaps are shares of it
}

crease_tap crease_stepped_tap(crease_stepped_march march, int step, int steps, int power) {
    float scale = 1.0 / float(steps);
    float along = float(step) * scale + march.offset * scale, density = 1.0;
    for (int i = 1; i < power; ++i)
        density *= along;
    float distance = density * along;
    vec2 texel = clamp(floor(march.first + march.radius * distance), vec2(0.0), crease_depth_size() - 1.0);
    bool inside = any(notEqual(texel, march.receiver)); // at the picture's edge it may find the receiver
    return crease_tap(texel, inside, density, distance, float(power) * scale / along);
}
#ifdef __cplusplus
")glsl"
#endif
