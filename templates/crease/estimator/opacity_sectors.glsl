// SPDX-License-Identifier: MIT-0
#ifdef __cplusplus
__LINE__, R"glsl("
#endif

// The sectors of 32 in which a layer of an opacity counts: as many as its share, spread evenly, and those of a lesser opacity
// among them. So what several taps find of one surface hides no more than its share, and of surfaces in one direction the
// most opaque counts, as in equation (1) of a-buffer-ssao 2013. Sectors come in the order of their bits reversed.
uint crease_sectors_of_opacity(float opacity) {
    uint count = uint(clamp(opacity, 0.0, 1.0) * 32.0 + 0.5);
    if (count == 32u)
        return ~0u;
    const uint halves[5] = uint[](0x55555555u, 0x33333333u, 0x0f0f0f0fu, 0x00ff00ffu, 0x0000ffffu);
    uint sectors = 0u, rest = ~0u;
    crease_unroll for (int i = 0; i < 5; ++i) {
        bool whole = (count >> uint(4 - i) & 1u) != 0u; // the first half of the rest
        sectors |= whole ? rest & halves[i] : 0u;
        rest &= whole ? ~halves[i] : halves[i];
    }
    return sectors;
}
#ifdef __cplusplus
")glsl"
#endif
