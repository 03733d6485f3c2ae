// SPDX-License-Identifier: MIT
#include "before_wall.hpp"
#include "command.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using crease::tools::image;
using crease::tools::read_image;

namespace {

/// A truth of 64 x 36 that the command wrote.
struct reference_files : written_pictures {
    reference_files(const std::string& scene, const std::string& options)
        : written_pictures("reference " + scene + " " + options) {}

    image operator[](const std::string& name) const { return written_pictures::operator[](name + ".pfm"); }
};

const std::set<std::string> always{"ao_hard.pfm", "ao_linear.pfm", "ao_linear.png", "ao_quad.pfm",
                                   "bent.pfm",    "depth.pfm",     "meta.json",     "normal.pfm"};

bool all_are(const std::vector<float>& values, float value) {
    return std::ranges::all_of(values, [=](float v) { return v == value; });
}

}

TEST_CASE("reference: a plane seen from above is open, flat and at one depth") {
    const reference_files plane(scene_files(false).arguments(), "--rays 16");
    CHECK(files_in(plane.folder / "out") == always);
    for (const char* name : {"ao_hard", "ao_linear", "ao_quad"})
        CHECK(all_are(plane[name].texels, 1));
    for (const float depth : plane["depth"].texels)
        CHECK(std::abs(depth - 4) <= 1e-6f);
    for (unsigned axis = 0; axis < 3; ++axis)
        CHECK(all_are(channel(plane["normal"], axis), axis == 2 ? 1 : 0));
    CHECK(std::ranges::all_of(png_of(plane.folder / "out/ao_linear.png"),
                              [](unsigned char v) { return v == 255; }));
    const nlohmann::json meta = json_in(plane.folder / "out/meta.json");
    CHECK(meta.at("camera") == "above");
    CHECK(meta.at("width") == 64);
    CHECK(meta.at("height") == 36);
    CHECK(meta.at("near") == 0.5);
    CHECK(meta.at("far") == 100);
    CHECK(meta.at("radius") == 2);
    CHECK(meta.at("rays") == 16);
    CHECK(meta.at("seed") == 1);
    CHECK(meta.at("triangles") == 2);
    CHECK(meta.at("scene").get<std::string>().ends_with("scene.obj"));
}

TEST_CASE("reference: a floor before a wall has the visibility of the closed form, and bends away from it") {
    const reference_files corner(scene_files(true).arguments(), "--rays 1024");
    const image hard = corner["ao_hard"], linear = corner["ao_linear"], quad = corner["ao_quad"],
                bent = corner["bent"];
    for (unsigned x = 0; x < 64; ++x) {
        const double away = scene_files::x_of(x);
        if (away < 0)
            continue;
        const visibility expected = before_wall(away / scene_files::radius);
        CHECK(std::abs(hard.at(x, 18) - expected.hard) <= 0.008);
        CHECK(std::abs(linear.at(x, 18) - expected.linear) <= 0.004);
        CHECK(std::abs(quad.at(x, 18) - expected.quad) <= 0.004);
        if (away < scene_files::radius / 2) {
            CHECK(bent.at(x, 18, 0) > 0.05f);
            CHECK(std::abs(bent.at(x, 18, 1)) < 0.02f);
            CHECK(bent.at(x, 18, 2) > 0.8f);
        } else if (away > scene_files::radius) {
            CHECK(std::abs(bent.at(x, 18, 0)) < 0.02f);
            CHECK(bent.at(x, 18, 2) > 0.999f);
        }
    }
}

TEST_CASE("reference: the mask is where what is hidden takes more than 0.15") {
    const reference_files built_in("built-in --width 64 --height 36", "--rays 32 --mask --seed 7");
    std::set<std::string> expected = always;
    expected.insert({"ao_first_layer.pfm", "mask.pfm", "mask.png"});
    CHECK(files_in(built_in.folder / "out") == expected);
    const image first = built_in["ao_first_layer"], all = built_in["ao_linear"], mask = built_in["mask"];
    const std::vector<unsigned char> picture = png_of(built_in.folder / "out/mask.png");
    REQUIRE(picture.size() == mask.texels.size());
    std::size_t hidden = 0;
    for (std::size_t i = 0; i < mask.texels.size(); ++i) {
        CHECK(mask.texels[i] == (first.texels[i] - all.texels[i] > 0.15f ? 1 : 0));
        CHECK(picture[i] == (mask.texels[i] == 1 ? 255 : 0));
        hidden += mask.texels[i] == 1;
    }
    CHECK(hidden > 20);
    CHECK(hidden < 64 * 36 / 4);
    CHECK(json_in(built_in.folder / "out/meta.json").at("seed") == 7);
}

TEST_CASE("reference: opacity of a scene, or of the command, is traced") {
    const reference_files glass("glass --width 64 --height 36", "--rays 16");
    CHECK(files_in(glass.folder / "out") == always);
    const nlohmann::json meta = json_in(glass.folder / "out/meta.json");
    CHECK(meta.at("camera") == "showroom");
    CHECK(meta.at("transparent") == "solids");
    CHECK_FALSE(meta.contains("opacity"));
    const reference_files hull("glass --width 64 --height 36", "--rays 16 --hull");
    CHECK(json_in(hull.folder / "out/meta.json").at("transparent") == "thin hulls");
    CHECK(hull["depth"].texels == glass["depth"].texels);
    CHECK(hull["ao_linear"].texels != glass["ao_linear"].texels);

    // A wall that stops half of each ray, seen beside a floor of which half is seen.
    const reference_files corner(scene_files(true).arguments(), "--rays 1024 --opacity 0.5");
    CHECK(json_in(corner.folder / "out/meta.json").at("opacity") == 0.5);
    const image hard = corner["ao_hard"];
    for (unsigned x = 0; x < 64; ++x)
        if (const double away = scene_files::x_of(x); away >= 0)
            CHECK(std::abs(1 - hard.at(x, 18) - 0.25 * (1 - before_wall(away / scene_files::radius).hard)) <=
                  0.002);
    const reference_files opaque(scene_files(true).arguments(), "--rays 16");
    CHECK_FALSE(json_in(opaque.folder / "out/meta.json").contains("transparent"));
}

TEST_CASE("reference: cameras beside the scene, or one that is fitted, and a line of each") {
    const scene_files scene(true);
    const temporary_folder folder;
    const std::string to = " --rays 1 --width 16 --height 9 -o '" + (folder / "out").string() + "'";
    const std::string said = expect_success("reference " + scene.scene() + to);
    CHECK(said.find("from 'above', 16 x 9, by 1 rays a texel\n") != std::string::npos);
    CHECK(std::ranges::count(said, '\n') == 1);
    const std::string alone =
        folder.put("alone.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 2 3\nf 1 2 4\n").string();
    const ended done = crease_command("reference '" + alone + "'" + to);
    CHECK(done.status == 0);
    CHECK(done.complained.find("alone.cameras.json; a camera is fitted to the scene: eye ") !=
          std::string::npos);
    CHECK(json_in(folder / "out/meta.json").at("camera") == "fitted");
    std::vector<float> depths = read_image(folder / "out/depth.pfm").texels;
    CHECK(std::ranges::count_if(depths, [](float z) { return z < 30; }) >= 5);
}

TEST_CASE("reference: a folder holds the files of one run, or those of the run before") {
    const temporary_folder folder;
    const std::string out = (folder / "out").string(), to = " --width 16 --height 9 -o '" + out + "'";
    expect_success("reference built-in --rays 1 --mask" + to);
    folder.put("out/mine", "kept");
    const std::set<std::string> masked = files_in(out);
    CHECK(masked.contains("mask.png"));
    const std::string before = content_of(folder / "out/meta.json");
    // Nothing can be replaced by what is a folder.
    std::filesystem::remove(folder / "out/depth.pfm");
    std::filesystem::create_directory(folder / "out/depth.pfm");
    CHECK(crease_command("reference built-in --rays 2" + to).status == 1);
    CHECK(content_of(folder / "out/meta.json") == before);
    std::filesystem::remove(folder / "out/depth.pfm");
    expect_success("render built-in --recipe directions:2x2/single_layer/hbao" + to);
    CHECK(files_in(out) == std::set<std::string>{"ao.pfm", "ao.png", "depth.pfm", "frame.exr", "meta.json",
                                                 "mine", "normal.pfm"});
}
