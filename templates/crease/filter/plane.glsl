// SPDX-License-Identifier: MIT-0
#ifndef __cplusplus
vec3 crease_view_position(vec2 texel, float depth);
crease_result crease_decode(uvec4 texel);
crease_result crease_weighted(crease_result result, float weight);
crease_result crease_sum(crease_result a, crease_result b);
#else
__LINE__, R"glsl("
#endif

// 1 / the distance from a tangent plane at which a weight ends. Depths are handed on exact to 2^-15 of themselves.
float crease_plane_sharpness(float depth) { return 1.0 / max(crease_plane_reach * crease_radius, 1e-4 * depth); }

// The tangent plane of a texel. What is (x, y) texels away at depth z is dot(near + z * ray, (x, y, 1)) reaches above it.
struct crease_plane {
    vec3 normal; // view space, unit
    vec3 near, ray;
};

crease_plane crease_plane_at(vec2 texel, float depth, vec3 normal) {
    vec3 up = normal * crease_plane_sharpness(depth);
    vec2 right = texel + vec2(1.0, 0.0), below = texel + vec2(0.0, 1.0);
    vec3 near = crease_view_position(texel, 0.0), far = crease_view_position(texel, 1.0);
    vec3 near_right = crease_view_position(right, 0.0) - near, near_below = crease_view_position(below, 0.0) - near;
    vec3 far_right = crease_view_position(right, 1.0) - far, far_below = crease_view_position(below, 1.0) - far;
    float rise = dot(far - near, up);
    return crease_plane(normal, vec3(dot(near_right, up), dot(near_below, up), -rise * depth),
                        vec3(dot(far_right - near_right, up), dot(far_below - near_below, up), rise));
}

// How much a surface counts that is `away` texels off: less with its distance from the plane, and with the angle of its
// normal, but a fifth at least, as visibility goes on over a crease and reconstructed normals err.
float crease_plane_weight(crease_plane plane, vec2 away, float depth, vec3 normal) {
    float height = dot(plane.near + depth * plane.ray, vec3(away, 1.0));
    float alike = max(dot(normal, plane.normal), 0.0);
    alike *= alike;
    alike *= alike;
    return max(1.0 - abs(height), 0.0) * max(alike * alike, 0.2);
}

// Adds the neighbour of a pixel that is `away` from it, at the picture's edge the last: by a Gaussian whose standard
// deviation is 3/4 of the radius, and by the tangent plane.
void crease_plane_add(inout crease_result sum, inout float weights, crease_plane plane, ivec2 pixel, ivec2 away,
                      int radius) {
    float spread = -1.28239 / float(radius * radius); // log2(e) / (2 (3/4)^2)
    ivec2 at = clamp(pixel + away, ivec2(0), crease_size(crease_divisor) - 1);
    vec2 apart = crease_texel_of_pixel(at, crease_divisor) - crease_texel_of_pixel(pixel, crease_divisor);
    crease_result other = crease_decode(crease_load_input(at));
    float weight = exp2(spread * dot(vec2(away), vec2(away))) *
        crease_plane_weight(plane, apart, other.depth, other.normal);
    sum = crease_sum(sum, crease_weighted(other, weight));
    weights += weight;
}
#ifdef __cplusplus
")glsl"
#endif
