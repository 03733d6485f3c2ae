// SPDX-License-Identifier: MIT
// The techniques as the papers state them, in double precision and apart from the shaders.
#pragma once

#include "picture.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace oracle {

/// The settings of an effect, as its parts name them.
struct settings {
    double radius = 1, bias = 0, threshold = 0, strength = 1, exponent = 1, sharpness = 8, falloff = 1,
           thickness = 0, thin_occluders = 0, plane_reach = 0.05;
    std::uint32_t frame = 0;
    std::string noise = "hashed_noise"; ///< as in a recipe, e.g. "tiled_noise:3"
};

/// Three numbers in [0, 1) of a pixel and a frame.
glm::dvec3 noise(int x, int y, const settings& s);

/// A layer of a texel.
struct seen_layer {
    glm::dvec3 position;
    double opacity = 1;
};

/// The layers of a texel, nearest first.
using layers_at = std::function<std::vector<seen_layer>(int x, int y)>;

/// A texel that a sampler proposes; for point samplers also the point, on the ray of the texel.
struct tap {
    int x, y;
    glm::dvec3 point;
    glm::dvec3 azimuth{0}; ///< of ordered taps: the marched direction, unit, across the direction to the eye
    int step = 0;          ///< of its direction, from 0, those off the picture counted
    double weight = 1;     ///< in a mean over the taps
};

/// How a traversal comes to the layers behind the front ones: after all fronts of their direction, or where
/// `looks` is 0 each tap looks at all layers at once.
struct deferral {
    unsigned looks = 0; ///< taps of each four steps behind which to look
    bool skip = false;  ///< not behind a front surface that settles its tap
};

/// The receiver of a pixel. One that is looked at from behind has its normal and its way to the eye turned
/// round.
struct receiver {
    int x, y;             ///< of the picture
    int pixel_x, pixel_y; ///< of the output, which may be smaller
    glm::dvec3 position, normal, to_eye;
};

/// How texel coordinates move with an offset in space that faces the eye, by the two points themselves.
glm::dvec2 texel_offset(const picture& p, const receiver& r, glm::dvec3 offset);

/// Two axes across the direction to the eye, the first of them level.
void axes(const picture& p, const receiver& r, glm::dvec3& across, glm::dvec3& up);

/// Normal from the depth of the neighbours: of left and right, and of up and down, the nearer in depth.
glm::dvec3 reconstruct_normal(const picture& p, int x, int y);

/// sin(h) - sin(t) of what stands at an offset from a receiver: h is its angle over the plane that faces the
/// eye, t that of the tangent plane, in the slice that holds the offset and the eye: stochastic-depth-ao,
/// figure 4.5.
double rise_over_tangent(const receiver& r, glm::dvec3 offset);

/// The angle of the tangent plane in the slice of an azimuth and the eye, radians.
double tangent_angle(const receiver& r, glm::dvec3 azimuth);

/// The share of a way across the picture, at most all of it, after which it leaves the picture.
double share_inside(const picture& p, glm::dvec2 from, glm::dvec2 way);

/// One of the four ways along the row and the column of a receiver.
struct axis_march {
    struct place {
        int x, y;      ///< where the picture ends, its edge
        double texels; ///< from the receiver
        bool counts;   ///< whether it is in the picture and no farther than the radius
    };
    glm::dvec3 azimuth; ///< that goes this way on the screen, unit, across the direction to the eye
    double radius;      ///< texels
    double stride;      ///< texels from a tap to the next
    std::vector<place> taps;
};

/// Right, left, down, up: even steps of a texel or more, up to the radius or the reach.
std::vector<axis_march> axis_marches(const picture& p, const receiver& r, const settings& s, int steps,
                                     int reach);

/// The radius, but no larger than half the picture's diagonal at the depth of a receiver.
double radius_inside(const picture& p, const receiver& r, double radius);

/// The taps of a receiver, direction by direction; those off the picture are left out.
std::vector<std::vector<tap>> directions(const picture& p, const receiver& r, const settings& s, int count,
                                         int steps, int power = 2);
std::vector<std::vector<tap>> poisson_disk(const picture& p, const receiver& r, const settings& s, int count);
std::vector<std::vector<tap>> axis_taps(const picture& p, const receiver& r, const settings& s, int steps,
                                        int reach);
std::vector<std::vector<tap>> hemisphere_points(const picture& p, const receiver& r, const settings& s,
                                                int count);

/// Occlusion in [0, 1] of a receiver from its taps.
double ssao(const picture& p, const receiver& r, const settings& s,
            const std::vector<std::vector<tap>>& taps);
double hbao(const picture& p, const receiver& r, const settings& s, const std::vector<std::vector<tap>>& taps,
            deferral how = {});
double hbao_plus(const picture& p, const receiver& r, const settings& s,
                 const std::vector<std::vector<tap>>& taps, deferral how = {});

/// A picture of visibilities, with the linear depth and the normals that filters read.
struct visibility_image {
    int width = 0, height = 0;
    std::vector<double> visibility, depth;
    std::vector<glm::dvec3> normals;
};

/// One separable cross-bilateral blur: rows, then columns.
visibility_image bilateral(const visibility_image& image, const settings& s, int radius);

/// A joint bilateral blur over a square, of a picture that is smaller than `p` by `divisor`: a texel counts
/// by a Gaussian, by its distance from the tangent plane and by the angle between the normals.
visibility_image plane_filter(const visibility_image& image, const picture& p, const settings& s, int radius,
                              int divisor = 1);
/// The same along rows, and then along columns.
visibility_image separable_plane_filter(const visibility_image& image, const picture& p, const settings& s,
                                        int radius, int divisor = 1);

/// From a picture that is smaller by `factor` to the size of `p`.
visibility_image upsample(const visibility_image& image, const picture& p, const settings& s, int factor);

}
