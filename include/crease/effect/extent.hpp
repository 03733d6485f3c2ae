// SPDX-License-Identifier: MIT
#pragma once

namespace crease {

/// How large an image is: the resolution of the picture divided by `divisor`, rounded up, on each axis; with
/// the guard band around it where it is `guarded`. Or of a fixed size. And how often that is halved, rounded
/// down, down to one texel: the size of a mip level.
struct extent {
    unsigned divisor = 1;      ///< of the picture's sides, > 0
    bool guarded = false;      ///< whether it has the guard band, on each side
    unsigned fixed_width = 0;  ///< texels; 0: follows the picture
    unsigned fixed_height = 0; ///< height, likewise
    unsigned level = 0;        ///< how often it is halved

    /// The sides of an image for a picture of a size, all in texels.
    /// @{
    constexpr unsigned width_of(unsigned picture_width, unsigned guard = 0) const {
        return halved(fixed_width ? fixed_width : of(picture_width, guard));
    }
    constexpr unsigned height_of(unsigned picture_height, unsigned guard = 0) const {
        return halved(fixed_height ? fixed_height : of(picture_height, guard));
    }
    /// @}
    /// Member by member.
    constexpr bool operator==(const extent&) const = default;

private:
    constexpr unsigned of(unsigned texels, unsigned guard) const {
        return (texels + divisor - 1) / divisor + (guarded ? 2 * guard : 0);
    }
    constexpr unsigned halved(unsigned texels) const {
        const unsigned half = level < 32 ? texels >> level : 0;
        return half || texels == 0 ? half : 1;
    }
};

}
