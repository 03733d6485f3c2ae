#ifdef __cplusplus
R"glsl("
#endif
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
#ifdef __cplusplus
")glsl"
#endif
