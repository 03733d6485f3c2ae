// SPDX-License-Identifier: MIT
// What geometry takes that the camera does not see.
#include "truth/truth.hpp"

#include "rectangles.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace crease::tools;

namespace {

/// A floor, and seen from above a narrow roof, 1 high, that hides a wall from the camera. The roof's depth
/// hides what is deeper by a tenth of the radius.
struct roofed_wall {
    mesh triangles;
    camera from = look({0, 4, 0}, {0, 0, 0}, {0, 0, -1});
    static constexpr float radius = 1;

    /// @param foot  where the wall ends below
    explicit roofed_wall(double foot) {
        add_rectangle(triangles, {-500, 0, -500}, {1000, 0, 0}, {0, 0, 1000});
        add_rectangle(triangles, {-0.05, 1, -500}, {0.1, 0, 0}, {0, 0, 1000});
        add_rectangle(triangles, {0, foot, -500}, {0, 1 - foot, 0}, {0, 0, 1000});
    }

    truth traced() const {
        return trace_truth(triangles, from,
                           {.width = 64, .height = 36, .radius = radius, .rays = 256, .first_layer = true});
    }
};

}

TEST_CASE("hidden: what the camera cannot see occludes nothing in the truth of the first layer") {
    const truth whole = roofed_wall(0).traced(), top_alone = roofed_wall(0.9).traced();
    double greatest = 0, takes = 0;
    for (unsigned y = 13; y < 23; ++y) // what lies outside the picture would count as seen
        for (unsigned x = 0; x < 64; ++x) {
            const double first = whole.ao_first_layer.at(x, y);
            greatest = std::max(greatest, std::abs(first - top_alone.ao_linear.at(x, y)));
            takes = std::max(takes, first - whole.ao_linear.at(x, y));
            CHECK(top_alone.ao_first_layer.at(x, y) == top_alone.ao_linear.at(x, y));
        }
    MESSAGE("first layer off by " << greatest << "; the wall takes up to " << takes);
    CHECK(greatest <= 0.004); // one ray; measured: 0
    CHECK(takes > 0.15);      // measured: 0.215
}

TEST_CASE("hidden: the mask is where it takes more than 0.15") {
    truth traced;
    traced.ao_first_layer = traced.ao_linear = image(6, 1);
    traced.ao_first_layer.texels = {1, 1, 0.5f, 0.4f, 0.5f, 0};
    traced.ao_linear.texels = {0.86f, 0.84f, 0.36f, 0.24f, 0.9f, 0};
    CHECK(hidden_mask(traced).texels == std::vector<float>{0, 1, 0, 1, 0, 0});
}
