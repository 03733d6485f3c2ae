// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The tap that is `along` of `steps` steps on the way to the radius, at distances that grow by a power of the steps, and a
// texel further, so that none falls on the receiver itself. What is beside the depth image is looked for at its edge.
crease_tap crease_stepped_tap(crease_receiver receiver, vec2 radius, float along, int steps, int power) {
    float scale = 1.0 / float(steps), density = 1.0;
    for (int i = 1; i < power; ++i)
        density *= along * scale;
    float distance = density * along * scale;
    vec2 texel = receiver.texel + 0.5 + radius * (distance + inversesqrt(max(dot(radius, radius), 1e-20)));
    return crease_tap(clamp(floor(texel), vec2(0.0), crease_depth_size() - 1.0), true, density, distance,
                      float(power) * scale * density);
}
#ifdef __cplusplus
")glsl"
#endif
