// SPDX-License-Identifier: MIT
#include "image/file.hpp"
#include "scene/scene.hpp"

#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <glm/geometric.hpp>

#include <cmath>

using namespace crease::tools;

namespace {

/// A list of one good camera, with one part of its text replaced.
std::string camera_json(const std::string& from = "", const std::string& to = "") {
    std::string text =
        R"([{"name": "a", "eye": [1, 2, 3], "target": [1, 2, -7], "up": [0, 1, 0], "vfov_deg": 40,
                            "near": 0.5, "far": 50, "width": 640, "height": 360, "ao_radius": 0.25}])";
    return text.replace(text.find(from), from.size(), to);
}

}

TEST_CASE("camera: every field is read") {
    const temporary_folder folder;
    const std::vector<camera> list = load_cameras(folder.put("a.json", camera_json()));
    REQUIRE(list.size() == 1);
    const camera& a = list[0];
    CHECK(a.name == "a");
    CHECK(a.eye == glm::dvec3(1, 2, 3));
    CHECK(a.target == glm::dvec3(1, 2, -7));
    CHECK(a.up == glm::dvec3(0, 1, 0));
    CHECK(a.vfov_deg == 40);
    CHECK(a.near == 0.5f);
    CHECK(a.far == 50);
    CHECK(a.width == 640);
    CHECK(a.height == 360);
    CHECK(a.ao_radius == 0.25f);
}

TEST_CASE("camera: a broken list is refused with the camera, the field and the reason") {
    const auto expect = [](const std::string& part, const std::string& text) {
        CAPTURE(text);
        expect_error<scene_error>("memory: " + part, [&] { parse_cameras(text, "memory"); });
    };
    expect("not JSON", "");
    expect("not JSON", "[{");
    expect("not JSON", camera_json("0.5", "NaN"));
    expect("not JSON", camera_json("0.5", "1e999"));
    expect("must be a list of at least one camera", "{}");
    expect("must be a list of at least one camera", "[]");
    expect("camera 0: must be an object", "[1]");
    expect("camera 0: \"name\" is missing", camera_json("\"name\"", "\"nom\""));
    expect("camera 0: \"name\" must be a text", camera_json("\"a\"", "1"));
    expect("camera 0: \"name\" must be a text", camera_json("\"a\"", "\"\""));
    const std::string a = "camera 0 ('a'): ";
    for (const std::string field :
         {"eye", "target", "up", "vfov_deg", "near", "far", "width", "height", "ao_radius"}) {
        expect(a + "\"" + field + "\" is missing", camera_json("\"" + field + "\"", "\"other\""));
        expect(a + "\"" + field + "\" must be",
               camera_json("\"" + field + "\":", "\"" + field + "\": null, \"other\":"));
    }
    expect(a + "\"eye\" must be three numbers, [x, y, z], each from -1e+30 to 1e+30",
           camera_json("[1, 2, 3]", "[1, 2]"));
    expect(a + "\"eye\" must be three numbers, [x, y, z], each from -1e+30 to 1e+30",
           camera_json("[1, 2, 3]", "[1, 2, \"3\"]"));
    expect(a + "\"eye\" must be three numbers, [x, y, z], each from -1e+30 to 1e+30",
           camera_json("[1, 2, 3]", "[1, 2, 1e300]"));
    expect(a + "\"target\" must differ from \"eye\"", camera_json("[1, 2, -7]", "[1, 2, 3]"));
    expect(a + "\"up\" must not be [0, 0, 0]", camera_json("[0, 1, 0]", "[0, 0, 0]"));
    expect(a + "\"up\" must not be parallel", camera_json("[0, 1, 0]", "[0, 0, 3]"));
    for (const std::string angle : {"0", "180", "-40", "1e30"})
        expect(a + "\"vfov_deg\" must be between 0 and 180", camera_json("40", angle));
    expect(a + "\"near\" must be greater than 0", camera_json("0.5", "0"));
    expect(a + "\"far\" must be greater than \"near\"", camera_json("50", "0.5"));
    for (const std::string side : {"0", "-1", "16385", "1.5", "1e30", "99999999999999999999"})
        expect(a + "\"width\" must be a whole number from 1 to 16384", camera_json("640", side));
    expect(a + "\"ao_radius\" must not be negative", camera_json("0.25", "-1"));
    const std::string one = camera_json();
    expect("camera 1: \"name\" 'a' is taken", one.substr(0, one.size() - 1) + "," + one.substr(1));
}

TEST_CASE("camera: a field that is unknown or stands twice is refused by name") {
    const auto expect = [](const std::string& part, const std::string& text) {
        expect_error<scene_error>("memory: " + part, [&] { parse_cameras(text, "memory"); });
    };
    expect(
        "camera 0 ('a'): \"fov\" is unknown; a camera has name, eye, target, up, vfov_deg, near, far, width, "
        "height, ao_radius",
        camera_json("\"near\"", "\"fov\": 3, \"near\""));
    expect("\"near\" stands twice in one camera", camera_json("\"far\"", "\"near\": 3, \"far\""));
    const std::string one = camera_json();
    CHECK(
        parse_cameras(one.substr(0, one.size() - 1) + "," + camera_json("\"a\"", "\"b\"").substr(1), "memory")
            .size() == 2);
}

TEST_CASE("camera: one that is fitted sees every corner of the scene, at any size and place") {
    for (const double size : {1e-6, 1.0, 1e30}) {
        CAPTURE(size);
        mesh scene;
        for (const glm::dvec3& p : {glm::dvec3(0), {1, 0, 0}, {0, 0.5, 0}, {0, 0, -0.1}})
            scene.positions.push_back(p * size);
        scene.positions.emplace_back(-1e30); // used by no triangle
        scene.indices = {0, 1, 2, 0, 2, 3};
        const camera from = fitted_camera(scene);
        const view_window window = window_of(from, 16.0 / 9);
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 seen =
                view_rotation(from) * (scene.positions[static_cast<std::size_t>(i)] - from.eye);
            CHECK(-seen.z > from.near);
            CHECK(-seen.z < from.far);
            const glm::dvec2 place = window.place_of(glm::dvec2(seen) / -seen.z);
            CHECK(std::abs(place.x) < 1);
            CHECK(std::abs(place.y) < 1);
        }
        CHECK(from.ao_radius / size > 0.05);
        CHECK(from.ao_radius / size < 0.06); // half the diagonal of the box, 1.12, is ten radii
    }
}

TEST_CASE("camera: the window of a picture") {
    camera from = parse_cameras(camera_json("40", "90"), "memory")[0];
    view_window window = window_of(from, 2);
    CHECK(glm::length(window.half - glm::dvec2(2, 1)) < 1e-7);
    CHECK(window.middle == glm::dvec2(0));
    from.shift = {0.5, -0.25}; // by half a width to the right, a quarter of a height down
    window = window_of(from, 2);
    CHECK(glm::length(window.middle - glm::dvec2(2, -0.5)) < 1e-7);
    CHECK(glm::length(window.place_of({4, -0.5}) - glm::dvec2(1, 0)) < 1e-7);
    from.orthographic = true; // the target is 10 away
    window = window_of(from, 2);
    CHECK(glm::length(window.half - glm::dvec2(20, 10)) < 1e-6);
    CHECK(glm::length(window.middle - glm::dvec2(20, -5)) < 1e-6);
}

TEST_CASE("camera: a missing file is named") {
    expect_error<file_error>("absent.json: no such file", [] { load_cameras("absent.json"); });
}

TEST_CASE("camera: found by name, or the names there are") {
    std::vector<camera> list(2);
    list[0].name = "front";
    list[1].name = "side";
    CHECK(&find_camera(list, "side") == &list[1]);
    expect_error<scene_error>("there is no camera 'top'; there are: front, side",
                              [&] { find_camera(list, "top"); });
}

TEST_CASE("camera: the view looks down -Z with +Y up") {
    camera from;
    from.eye = {5, 1, 2};
    from.target = {9, 1, 2}; // along +X, so that +Z is to the right
    const glm::dmat4 view = view_matrix(from);
    const auto seen = [&](double x, double y, double z) { return glm::dvec3(view * glm::dvec4(x, y, z, 1)); };
    CHECK(glm::distance(seen(5, 1, 2), {0, 0, 0}) <= 4e-16);
    CHECK(glm::distance(seen(8, 1, 2), {0, 0, -3}) <= 4e-16);
    CHECK(glm::distance(seen(5, 2, 2), {0, 1, 0}) <= 4e-16);
    CHECK(glm::distance(seen(5, 1, 4), {2, 0, 0}) <= 4e-16);
    CHECK(view_rotation(from) == glm::dmat3(view));
}
