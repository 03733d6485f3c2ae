// SPDX-License-Identifier: MIT
#include "before_wall.hpp"
#include "command.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using crease::tools::image;
using crease::tools::read_image;

namespace {

/// A picture of 64 x 36 that the command wrote.
struct render_files : written_pictures {
    render_files(const std::string& scene, const std::string& options)
        : written_pictures("render " + scene + " " + options + " --validation") {}
};

const std::set<std::string> always{"ao.pfm", "ao.png", "depth.pfm", "frame.exr", "meta.json", "normal.pfm"};

unsigned char byte_of(float value) {
    return static_cast<unsigned char>(std::clamp(value * 255 + 0.5f, 0.0f, 255.0f));
}

}

TEST_CASE("render: a plane seen from above is open, flat and at one depth") {
    const render_files plane(
        scene_files(false).arguments(),
        "--recipe directions:8x4/single_layer/hbao/bilateral --set hbao.bias=0.25 --frame 3 --guard 5");
    CHECK(files_in(plane.folder / "out") == always);
    for (const float visible : plane["ao.pfm"].texels)
        CHECK(visible == 1);
    for (const float depth : plane["depth.pfm"].texels)
        CHECK(std::abs(depth - 4) <= 1e-5f);
    for (unsigned axis = 0; axis < 3; ++axis)
        for (const float n : channel(plane["normal.pfm"], axis))
            CHECK(n == (axis == 2 ? 1 : 0));
    const nlohmann::json meta = json_in(plane.folder / "out/meta.json");
    CHECK(meta.at("camera") == "above");
    CHECK(meta.at("width") == 64);
    CHECK(meta.at("height") == 36);
    CHECK(meta.at("near") == 0.5);
    CHECK(meta.at("far") == 100);
    CHECK(meta.at("radius") == 2);
    const bool on_processor = meta.at("device").get<std::string>().find("llvmpipe") != std::string::npos;
    CHECK(meta.at("recipe") == std::string("directions:8x4x2/single_layer/hbao/bilateral:3") +
                                   (on_processor ? "/image_load/compute_columns:16x16x16" : ""));
    CHECK(meta.at("settings").at("hbao.bias").get<float>() == 0.25f);
    CHECK(meta.at("settings").at("strength").get<float>() == 1.15f);
    CHECK(meta.at("frame") == 3);
    CHECK(meta.at("guard") == 5);
    CHECK_FALSE(meta.at("device").get<std::string>().empty());
    CHECK(meta.at("captures").empty());
    CHECK(meta["settings"].size() == 5); // hbao.bias, hbao.threshold, strength, exponent, bilateral.sharpness
    REQUIRE(meta.at("passes").size() == 3);
    for (const nlohmann::json& pass : meta["passes"]) {
        CHECK(pass.at("name").is_string());
        CHECK(pass.at("milliseconds").is_number());
    }
}

TEST_CASE("render: the EXR file has the pictures by name, and the PNG the visibility times 255") {
    const render_files corner("built-in --width 64 --height 36", "--recipe directions:4x4/single_layer/hbao");
    const image ao = corner["ao.pfm"], normal = corner["normal.pfm"];
    const std::filesystem::path exr = corner.folder / "out/frame.exr";
    CHECK(exr_channel_of(exr, "visibility") == ao.texels);
    CHECK(exr_channel_of(exr, "depth.Z") == corner["depth.pfm"].texels);
    CHECK(exr_channel_of(exr, "normal.X") == channel(normal, 0));
    CHECK(exr_channel_of(exr, "normal.Y") == channel(normal, 1));
    CHECK(exr_channel_of(exr, "normal.Z") == channel(normal, 2));
    CHECK(channel(normal, 0) != channel(normal, 1));
    const std::vector<unsigned char> picture = png_of(corner.folder / "out/ao.png");
    REQUIRE(picture.size() == ao.texels.size());
    for (std::size_t i = 0; i < picture.size(); ++i)
        CHECK(picture[i] == byte_of(ao.texels[i]));
    CHECK(*std::ranges::min_element(picture) < 160);
}

TEST_CASE("render: a floor before a wall is as dark as a volume behind it, and bends away from it") {
    const render_files corner(
        scene_files(true).arguments(),
        "--recipe directions:16x16/single_layer/hbao/bent_cone --set strength=1 --set bias=0 "
        "--guard 32");
    std::set<std::string> expected = always;
    expected.insert({"bent.pfm", "bent.png", "cone.pfm", "cone.png"});
    CHECK(files_in(corner.folder / "out") == expected);
    const image ao = corner["ao.pfm"], bent = corner["bent.pfm"], cone = corner["cone.pfm"];
    double difference = 0;
    unsigned count = 0;
    for (unsigned x = 0; x < 64; ++x) {
        const double away = scene_files::x_of(x);
        if (away < 0)
            continue;
        difference += std::abs(ao.at(x, 18) - before_wall(away / scene_files::radius).quad);
        ++count;
        if (away < scene_files::radius / 2) {
            CHECK(bent.at(x, 18, 0) > 0.05f);
            CHECK(std::abs(bent.at(x, 18, 1)) < 0.1f);
            CHECK(bent.at(x, 18, 2) > 0.7f);
        } else if (away > 1.1 * scene_files::radius) {
            CHECK(ao.at(x, 18) == 1);
            CHECK(bent.at(x, 18, 2) > 0.999f);
        }
    }
    MESSAGE("mean difference to the closed form: " << difference / count);
    CHECK(difference / count <= 0.028); // measured: 0.007
    const std::vector<unsigned char> bent_picture = png_of(corner.folder / "out/bent.png"),
                                     cone_picture = png_of(corner.folder / "out/cone.png");
    REQUIRE(bent_picture.size() == bent.texels.size());
    REQUIRE(cone_picture.size() == cone.texels.size());
    for (std::size_t i = 0; i < bent_picture.size(); ++i)
        CHECK(std::abs(bent_picture[i] - (bent.texels[i] / 2 + 0.5) * 255) <= 0.51);
    for (std::size_t i = 0; i < cone_picture.size(); ++i)
        CHECK(std::abs(cone_picture[i] - cone.texels[i] * 2 / std::numbers::pi * 255) <= 0.51);
}

TEST_CASE("render: captures have their times apart from passes, and the recipe says what kept the layers") {
    const render_files corner("built-in --width 64 --height 36",
                              "--recipe directions:4x4/stochastic_layers:4/hbao --set opacity=0.25 "
                              "--set strength=1.5");
    const nlohmann::json meta = json_in(corner.folder / "out/meta.json");
    const std::string recipe = meta.at("recipe");
    CHECK(recipe.starts_with("directions:4x4x2/stochastic_layers:4/hbao/"));
    const bool is_kept = recipe.find("/centred_samples:0x0x0") != std::string::npos ||
                         recipe.find("/multisampled:0x0x0") != std::string::npos ||
                         recipe.find("/atomic_minimum:0x0x0") != std::string::npos;
    CHECK(is_kept);
    CHECK(meta.at("settings").at("opacity") == 0.25);
    CHECK(meta["settings"].at("strength") == 1.5);
    REQUIRE(meta.at("captures").size() == 1);
    CHECK(meta["captures"][0].at("name") == "capture_layers");
    REQUIRE(meta.at("passes").size() == 2);
    CHECK(meta["passes"][0].at("name") == "pack_layers");
    CHECK(meta["passes"][1].at("name") == "visibility");
}

TEST_CASE("render: orthographic and off-centre, at each kind of depth") {
    const scene_files plane(false);
    for (const std::string lens :
         {"", "--orthographic ", "--shift 0.25 -0.5 ", "--orthographic --shift 0.25 -0.5 "})
        for (const std::string kind : {"reversed", "standard", "infinite"}) {
            if (lens.starts_with("--ortho") && kind == "infinite")
                continue;
            CAPTURE(lens);
            CAPTURE(kind);
            const render_files seen(plane.scene(),
                                    "--recipe directions:4x4/single_layer/hbao --depth " + kind + " " + lens);
            for (const float depth : seen["depth.pfm"].texels)
                CHECK(std::abs(depth - 4) <= 1e-4f);
            for (const float visible : seen["ao.pfm"].texels)
                CHECK(visible == 1);
            const nlohmann::json meta = json_in(seen.folder / "out/meta.json");
            CHECK(meta.at("depth") == kind);
            CHECK(meta.at("projection") == (lens.starts_with("--ortho") ? "orthographic" : "perspective"));
            CHECK((meta.at("recipe").get<std::string>().find("/orthographic") != std::string::npos) ==
                  lens.starts_with("--ortho"));
        }
}

TEST_CASE("render: a run that fails leaves the folder as it was, and one that ends says so in a line") {
    const temporary_folder folder;
    const std::string out = (folder / "out").string();
    const std::string render = "render built-in --width 16 --height 9 -o '" + out +
                               "' --recipe directions:2x2/single_layer/hbao --set strength=";
    const std::string said = expect_success(render + "1");
    CHECK(said.starts_with(out + ": visibility of 'built-in' from 'overview', 16 x 9, in "));
    CHECK(std::ranges::count(said, '\n') == 1);
    const std::string before = content_of(folder / "out/ao.pfm");
    CHECK(crease_command(render + "17").status == 2);
    CHECK(content_of(folder / "out/ao.pfm") == before);
    CHECK(json_in(folder / "out/meta.json").at("measured").get<std::string>().find("median") !=
          std::string::npos);
    expect_success(render + "2");
    CHECK(content_of(folder / "out/ao.pfm") != before);
}

TEST_CASE("render: what a bounded depth source lost is a warning that says what to do") {
    const scene_files scene(true);
    const temporary_folder folder;
    const auto complained = [&](const std::string& source) {
        const ended run =
            crease_command("render " + scene.arguments() + " --validation --recipe directions:2x4/" + source +
                           "/hbao -o '" + (folder / source).string() + "'");
        CHECK(run.status == 0);
        CHECK(std::filesystem::exists(folder / source / "ao.pfm"));
        return run.complained;
    };
    for (const std::string source : {"layer_array:1", "linked_lists:1x1"}) {
        const std::string said = complained(source);
        CAPTURE(said);
        CHECK(said.starts_with("crease: warning: "));
        CHECK(said.ends_with(
            " fragments that lie behind the layers kept of their texel: more layers keep them\n"));
    }
    CHECK(complained("layer_array:4") == "");
    CHECK(complained("linked_lists:4x4") == "");
}

TEST_CASE(
    "render: a wall and a floor that let half through occlude half as much, and half as much is seen of it") {
    const render_files corner(
        scene_files(true).arguments(),
        "--opacity 0.5 --recipe half_directions:4x16/linked_lists:4x4/cosine_bitmask:1/every_layer");
    CHECK(files_in(corner.folder / "out") == always);
    const nlohmann::json meta = json_in(corner.folder / "out/meta.json");
    CHECK(meta.at("opacity") == 0.5);
    CHECK(meta.at("captures").size() == 1);
    const image ao = corner["ao.pfm"];
    for (unsigned x = 0; x < 64; ++x)
        if (const double away = scene_files::x_of(x); away > 0.1) {
            const double expected = 1 - 0.25 * (1 - before_wall(away / scene_files::radius).linear);
            CHECK(std::abs(ao.at(x, 18) - expected) <= 0.05);
        }
}

TEST_CASE("render: behind glass there is ambient occlusion, which a single layer has not") {
    const std::string view = "glass --camera car --width 64 --height 36";
    const temporary_folder folder;
    expect_success("reference " + view + " --rays 64 -o '" + (folder / "truth").string() + "'");
    const image truth = read_image(folder / "truth/ao_linear.pfm");
    const auto error_of = [&](const std::string& recipe) {
        const image ao = render_files(view, "--recipe " + recipe)["ao.pfm"];
        double sum = 0;
        for (std::size_t i = 0; i < ao.texels.size(); ++i)
            sum += std::pow(ao.texels[i] - truth.texels[i], 2) / static_cast<double>(ao.texels.size());
        return std::sqrt(sum);
    };
    const double single = error_of("half_directions:4x8/single_layer/cosine_bitmask:1"),
                 every = error_of("half_directions:4x8/linked_lists:8x16/cosine_bitmask:1/every_layer");
    MESSAGE("RMSE of a single layer " << single << ", of every layer " << every);
    CHECK(every < 0.7 * single);
}

TEST_CASE("render: what moves before a wall hides nothing of it") {
    const temporary_folder folder;
    const std::string wall = "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\n",
                      pane = "v -1 -1 1\nv 1 -1 1\nv 1 1 1\n"
                             "v -1 1 1\n",
                      scene = "'" +
                              folder.put("a.obj", wall + pane + "g wall\nf 1 2 3 4\ng pane\nf 5 6 7 8\n")
                                  .string() +
                              "'";
    folder.put("a.cameras.json",
               R"([{"name": "before", "eye": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0],
        "vfov_deg": 60, "near": 0.5, "far": 100, "width": 64, "height": 36, "ao_radius": 1.5}])");
    const auto with = [&](const std::string& source, const std::string& options) {
        return render_files(scene, "--recipe half_directions:4x8/" + source + "/cosine_bitmask:1 " +
                                       options)["ao.pfm"];
    };
    const image two = with("static_and_dynamic_layers", "--dynamic pane"),
                turned = with("static_and_dynamic_layers", "--dynamic wall"), all = with("layer_array:2", ""),
                same = with("static_and_dynamic_layers", "--dynamic wall --dynamic pane"),
                single = with("layer_array:1", "");
    CHECK(two.texels == all.texels);
    CHECK(turned.texels == all.texels);
    CHECK(same.texels == single.texels);
    CHECK(all.texels != single.texels);
    CHECK(
        json_in(
            render_files(scene, "--dynamic pane --recipe directions/static_and_dynamic_layers/hbao").folder /
            "out/meta.json")
            .at("dynamic") == nlohmann::json{"pane"});
}

TEST_CASE("render: colours of layers, each over those behind it") {
    // A white floor of which half is seen, over white; the wall's edge is to the left of the middle.
    const render_files plane(
        scene_files(false).arguments(),
        "--opacity 0.5 --recipe directions:2x2/linked_lists:4x4/hbao/every_layer/composite");
    std::set<std::string> expected = always;
    expected.insert({"color.pfm", "color.png"});
    CHECK(files_in(plane.folder / "out") == expected);
    for (const float c : plane["color.pfm"].texels)
        CHECK(c == 1);
    CHECK(std::ranges::all_of(png_of(plane.folder / "out/color.png"),
                              [](unsigned char c) { return c == 255; }));
    const std::filesystem::path exr = plane.folder / "out/frame.exr";
    for (const char* name : {"color.R", "color.G", "color.B", "color.A"})
        for (const float c : exr_channel_of(exr, name))
            CHECK(std::abs(c - 0.5f) <= 0.002f); // of eight bits
    const temporary_folder folder;
    folder.put("a.mtl", "newmtl red\nKd 1 0 0\nd 0.5\nnewmtl blue\nKd 0 0 1\nd 1\n");
    const std::string scene = folder
                                  .put("a.obj", "mtllib a.mtl\nv -9 0 -9\nv 9 0 -9\nv 9 0 9\nv -9 0 9\n"
                                                "v -9 1 -9\nv 9 1 -9\nv 9 1 9\nv -9 1 9\n"
                                                "usemtl blue\nf 1 2 3 4\nusemtl red\nf 5 6 7 8\n")
                                  .string();
    folder.put("a.cameras.json",
               R"([{"name": "above", "eye": [0, 4, 0], "target": [0, 0, 0], "up": [0, 0, -1],
                                     "vfov_deg": 40, "near": 0.5, "far": 100, "width": 64, "height": 36,
                                     "ao_radius": 0}])");
    const render_files sheets("'" + scene + "'",
                              "--recipe directions:2x2/linked_lists:4x4/hbao/every_layer/composite");
    const image seen = sheets["color.pfm"];
    for (std::size_t i = 0; i < seen.texels.size(); i += 3) {
        CHECK(std::abs(seen.texels[i] - 0.5f) <= 0.003f);
        CHECK(seen.texels[i + 1] <= 0.003f);
        CHECK(std::abs(seen.texels[i + 2] - 0.5f) <= 0.003f);
    }
}
