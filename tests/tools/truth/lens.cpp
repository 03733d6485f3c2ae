// SPDX-License-Identifier: MIT
#include "truth/truth.hpp"

#include "before_wall.hpp"
#include "rectangles.hpp"

#include <doctest/doctest.h>

using namespace crease::tools;

namespace {

/// The floor at y = 0 before a wall at x = 0, seen from 8 above (2, 0, 0): the picture's right is along x,
/// its top along -z, and it shows 8 x 4 of the floor.
struct above_floor {
    mesh scene;
    camera from = look({2, 8, 0}, {2, 0, 0}, {0, 0, -1});
    truth_settings settings{.width = 64, .height = 32, .radius = 2, .rays = 256};

    above_floor() {
        add_rectangle(scene, {0, 0, -90}, {90, 0, 0}, {0, 0, 180});
        add_rectangle(scene, {0, 0, -90}, {0, 90, 0}, {0, 0, 180});
        from.vfov_deg = 28.072487f; // 2 atan(2 / 8)
    }

    truth traced() const { return trace_truth(scene, from, settings); }
};

}

TEST_CASE("lens: an orthographic camera sees what lies straight below") {
    above_floor view;
    view.from.orthographic = true;
    const truth seen = view.traced();
    for (unsigned x = 0; x < 64; ++x) {
        const double away = 2 + 8 * ((x + 0.5) / 64 - 0.5);
        CAPTURE(away);
        if (away < 0) {
            CHECK(seen.depth.at(x, 16) == view.from.far);
            continue;
        }
        CHECK(std::abs(seen.depth.at(x, 16) - 8) <= 1e-5f);
        CHECK(std::abs(seen.ao_hard.at(x, 16) - before_wall(away / 2).hard) <= 0.02);
    }
}

TEST_CASE("lens: a shifted picture is a part of a larger one") {
    for (const bool orthographic : {false, true}) {
        CAPTURE(orthographic);
        above_floor large;
        large.from.orthographic = orthographic;
        large.settings.rays = 1;
        above_floor quarter = large; // the lower right
        quarter.settings.width /= 2;
        quarter.settings.height /= 2;
        quarter.from.vfov_deg = 14.250033f; // 2 atan(1 / 8)
        quarter.from.shift = {0.5, -0.5};
        const truth whole = large.traced(), part = quarter.traced();
        for (unsigned y = 0; y < 16; ++y)
            for (unsigned x = 0; x < 32; ++x)
                CHECK(std::abs(part.depth.at(x, y) - whole.depth.at(x + 32, y + 16)) <= 1e-4f);
    }
}

TEST_CASE("lens: what an orthographic camera cannot see does not occlude in the first layer") {
    above_floor view;
    view.from.orthographic = true;
    view.settings.first_layer = true;
    add_rectangle(view.scene, {1, 1, -2}, {2, 0, 0},
                  {0, 0, 4}); // a table; the wall's foot is seen, its side not
    const truth seen = view.traced();
    CHECK(seen.depth.at(32, 16) == doctest::Approx(7));
    const auto below = [&](const image& of) { return of.at(50, 16); }; // the floor at x = 4.3, beside it
    CHECK(below(seen.ao_first_layer) >= below(seen.ao_linear));
}
