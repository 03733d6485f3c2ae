// SPDX-License-Identifier: MIT
#include "truth/kept_truth.hpp"

#include "image/file.hpp"

#include "rectangles.hpp"
#include "temporary_folder.hpp"

#include <doctest/doctest.h>

using namespace crease::tools;

namespace {

/// A floor before a wall, and a camera above it.
struct view_of_corner {
    mesh scene;
    camera from = look({1, 3, 0}, {1, 0, 0}, {0, 0, -1});
    truth_settings settings{.width = 8, .height = 6, .radius = 1, .rays = 16};
    unsigned traced = 0;
    std::string said;

    view_of_corner() {
        add_rectangle(scene, {0, 0, -9}, {9, 0, 0}, {0, 0, 18});
        add_rectangle(scene, {0, 0, -9}, {0, 9, 0}, {0, 0, 18});
    }

    /// Whether it was traced.
    bool asks(const temporary_folder& folder) {
        bool was_traced = false;
        said.clear();
        settings.progress = [&](double) { return was_traced = true; };
        const truth kept = kept_truth(folder / "truths", "corner/../x", scene, from, settings,
                                      [&](const std::string& sentence) { said += sentence; });
        settings.progress = {};
        const truth right = trace_truth(scene, from, settings);
        for (const auto pixels : {&truth::ao_hard, &truth::ao_linear, &truth::ao_quad, &truth::bent,
                                  &truth::depth, &truth::normal, &truth::ao_first_layer})
            CHECK((kept.*pixels).texels == (right.*pixels).texels);
        return was_traced;
    }
};

}

TEST_CASE("kept truth: it is traced once, and again where anything that it follows from is another") {
    const temporary_folder folder;
    view_of_corner view;
    CHECK(view.asks(folder));
    CHECK(view.said.empty());
    CHECK_FALSE(view.asks(folder));
    CHECK(folder.files() == 1);
    const auto differs = [&](auto change) {
        view_of_corner other;
        change(other);
        CHECK(other.asks(folder));
        CHECK(other.said.find("are of another scene, camera") != std::string::npos);
        CHECK_FALSE(other.asks(folder));
    };
    differs([](view_of_corner& v) { v.scene.positions[5].y = 2; });
    differs([](view_of_corner& v) { std::swap(v.scene.indices[0], v.scene.indices[1]); });
    differs([](view_of_corner& v) { v.from.eye.x = 1.5; });
    differs([](view_of_corner& v) { v.from.target.x = 1.5; });
    differs([](view_of_corner& v) { v.from.up.x = 0.5; });
    differs([](view_of_corner& v) { v.from.vfov_deg = 50; });
    differs([](view_of_corner& v) { v.from.near = 0.5f; });
    differs([](view_of_corner& v) { v.from.far = 50; });
    differs([](view_of_corner& v) { v.from.orthographic = true; });
    differs([](view_of_corner& v) { v.from.shift.x = 0.1; });
    differs([](view_of_corner& v) { v.from.shift.y = 0.1; });
    differs([](view_of_corner& v) { v.settings.width = 9; });
    differs([](view_of_corner& v) { v.settings.height = 7; });
    differs([](view_of_corner& v) { v.settings.radius = 2; });
    differs([](view_of_corner& v) { v.settings.rays = 17; });
    differs([](view_of_corner& v) { v.settings.seed = 2; });
    differs([](view_of_corner& v) { v.scene = with_opacity(v.scene, 0.5f); });
    differs([](view_of_corner& v) { v.scene = with_opacity(v.scene, 0.25f); });
    differs([](view_of_corner& v) {
        v.scene = with_opacity(v.scene, 0.5f);
        v.settings.hull = true;
    });
    view_of_corner painted;
    paint(painted.scene, {{1, 0, 0, 1}}); // which no ray sees
    CHECK_FALSE(painted.asks(folder));
    CHECK_FALSE(view.asks(folder));
    CHECK(folder.files() == 1); // whatever the label
}

TEST_CASE("kept truth: what is broken is traced anew, with a sentence") {
    const temporary_folder folder;
    view_of_corner view;
    CHECK(view.asks(folder));
    const std::filesystem::path kept = std::filesystem::directory_iterator(folder / "truths")->path();
    const std::string bytes = content_of(kept / "bent.pfm");
    const auto mends = [&](const std::string& file, const std::string& content, const std::string& sentence) {
        CAPTURE(sentence);
        write_atomically(kept / file, content);
        CHECK(view.asks(folder));
        CHECK(view.said.find(sentence) != std::string::npos);
        CHECK(view.said.find("is traced anew") != std::string::npos);
        CHECK_FALSE(view.asks(folder));
    };
    mends("bent.pfm", bytes.substr(1), "bent.pfm: not a PFM file");
    mends("bent.pfm", bytes.substr(0, 60), "bent.pfm: truncated");
    mends("bent.pfm", bytes.substr(0, bytes.size() - 1) + "x", "bent.pfm: is not as it was written");
    mends("content.json", "{", "parse error");
    mends("content.json", "{}", "not found");
    std::filesystem::remove(kept / "ao_hard.pfm");
    CHECK(view.asks(folder));
    CHECK(view.said.find("ao_hard.pfm: no such file") != std::string::npos);
}

TEST_CASE("kept truth: the first layer is traced where it is asked for the first time") {
    const temporary_folder folder;
    view_of_corner view;
    CHECK(view.asks(folder));
    view.settings.first_layer = true;
    CHECK(view.asks(folder));
    CHECK_FALSE(view.asks(folder));
    view.settings.first_layer = false;
    CHECK_FALSE(view.asks(folder));
}
