// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <doctest/doctest.h>

namespace {

constexpr int failure = 1, usage = 2;

/// Expects that the command ends with a status, says `sentence`, and writes nothing.
void expect_refusal(int status, const std::string& sentence, const std::string& arguments,
                    bool takes_output = true) {
    const temporary_folder folder;
    const ended done =
        crease_command(arguments + (takes_output ? " -o '" + (folder / "out").string() + "'" : ""));
    CAPTURE(arguments);
    CAPTURE(done.complained);
    CHECK(done.status == status);
    CHECK(done.complained.find(sentence) != std::string::npos);
    CHECK(done.complained.find("crease: crease") == std::string::npos);
    for (std::size_t digits = 0; const char c : done.complained) {
        digits = c >= '0' && c <= '9' ? digits + 1 : 0;
        CHECK(digits < 20); // numbers are short
    }
    CHECK(done.said.empty());
    CHECK(folder.files() == 0);
}

constexpr const char* hbao = " --recipe directions:8x4/single_layer/hbao/bilateral";

/// A camera before the ground of `scene_files`, with some of its text replaced.
std::string cameras_with(const std::string& fields) {
    return R"([{"name": "a", "target": [2, 0, 0], "up": [0, 0, -1], "vfov_deg": 40, "width": 8, "height": 8, )" +
           fields + "}]";
}

}

TEST_CASE("refuses: recipes") {
    expect_refusal(usage, "no part of the name 'nothing'", "emit nothing/single_layer/hbao");
    expect_refusal(usage, "needs taps in order along directions", "emit poisson_disk/single_layer/hbao");
    expect_refusal(usage, "can be emitted of programs in the dialects vulkan and webgpu only",
                   "emit directions/single_layer/hbao --dialect opengl --format spirv");
    expect_refusal(usage, "'1a' is no C++ identifier",
                   "emit directions/single_layer/hbao --format header --name 1a");
    expect_refusal(usage, "no part of the name 'nothing'",
                   "render built-in --recipe nothing/single_layer/hbao");
    expect_refusal(usage, "a recipe that is run is of programs in the vulkan dialect",
                   "render built-in --recipe directions/single_layer/hbao/opengl");
    expect_refusal(usage, "nothing of the scene is dynamic; name nodes or groups of it by --dynamic",
                   "render built-in --recipe directions/static_and_dynamic_layers/hbao");
    expect_refusal(failure,
                   "built-in: --dynamic: no triangle is of a node or group named 'car'; the scene names none",
                   "render built-in --dynamic car --recipe directions/static_and_dynamic_layers/hbao");
    expect_refusal(usage, "--dynamic: the recipe draws all geometry alike; take static_and_dynamic_layers",
                   std::string("render built-in --dynamic car") + hbao);
    expect_refusal(usage, "no part of the name 'nothing'", "bench --recipes nothing/single_layer/hbao",
                   false);
}

TEST_CASE("refuses: settings") {
    const std::string render = std::string("render built-in") + hbao;
    expect_refusal(usage, "no part of this recipe has the setting 'colour'; there are hbao.bias, ",
                   render + " --set colour=1");
    expect_refusal(usage, "--set bias=x: it must read name=number", render + " --set bias=x");
    expect_refusal(usage, "--set bias: it must read name=number", render + " --set bias");
    expect_refusal(usage, "strength=-1 is out of its range, 0 to 16", render + " --set strength=-1");
    expect_refusal(usage, "no part of this recipe has the setting 'hbao_plus.bias'",
                   render + " --set hbao_plus.bias=0");
    expect_refusal(usage, "hbao.bias=2 is out of its range, 0 to 1.5", render + " --set hbao.bias=2");
    expect_refusal(usage, "bias=2 is out of its range, 0 to 1.5", render + " --set bias=2");
    expect_refusal(usage, "strength=nan is out of its range, 0 to 16", render + " --set strength=nan");
    expect_refusal(usage, "it must read name=number", "bench --recipes directions/single_layer/hbao@bias",
                   false);
}

TEST_CASE("refuses: scenes, cameras and devices") {
    expect_refusal(failure, "missing.glb: no such file",
                   std::string("render missing.glb --cameras missing.json") + hbao);
    expect_refusal(failure, "missing.glb: no such file", "reference missing.glb --cameras missing.json");
    expect_refusal(failure, "missing.glb: no such file", "bench missing.glb", false);
    expect_refusal(failure, "there is no camera 'nowhere'; there are: overview, ",
                   std::string("render built-in --camera nowhere") + hbao);
    expect_refusal(failure, "there is no camera 'nowhere'", "reference built-in --camera nowhere");
    expect_refusal(failure, "none of the scenes has the camera 'nowhere'",
                   "bench --width 8 --height 8 --rays 1 --cameras overview --cameras nowhere", false);
    expect_refusal(failure, "there is no camera 'nowhere'",
                   "render built-in --second-camera nowhere --recipe "
                   "directions:2x2/stochastic_layers:2/hbao_plus/second_view");
    for (const std::string& command : {std::string("render built-in") + hbao, std::string("demo")})
        expect_refusal(failure, "no Vulkan device named 'abacus'", command + " --device abacus");
    expect_refusal(failure, "no Vulkan device named 'abacus'", "bench --device abacus", false);
    const temporary_folder folder;
    const std::string scene =
        "'" + folder.put("a.obj", "v 0 0 0\nv 9 0 0\nv 0 0 9\nf 1 2 3\n").string() + "'";
    folder.put("a.cameras.json", cameras_with(R"("eye": [2, 4, 0], "near": 5, "far": 9, "ao_radius": 1)"));
    for (const std::string& command : {std::string("render "), std::string("reference ")})
        expect_refusal(failure, "the camera 'a' sees nothing of the scene between near, 5, and far, 9",
                       command + scene + (command == "render " ? hbao : ""));
    expect_refusal(failure, "the camera 'a' sees nothing of the scene", "bench " + scene, false);
}

TEST_CASE("refuses: materials") {
    const temporary_folder folder;
    const std::string obj =
        "'" + folder.put("a.obj", "mtllib a.mtl\nusemtl a\nv 0 0 0\nv 9 0 0\nv 0 0 9\nf 1 2 3\n").string() +
        "'";
    folder.put("a.mtl", "newmtl a\nd nan\n");
    expect_refusal(failure,
                   "a.obj: needs 'a.mtl': line 2: 'nan' is not a number from 0 to 1; export it again",
                   "reference " + obj);
    folder.put("a.mtl", "newmtl a\nd 0\n");
    expect_refusal(failure, "every triangle of the scene has opacity 0, so that nothing is seen",
                   "reference " + obj);
}

TEST_CASE("refuses: eyes and depths that 32 bits cannot hold") {
    const temporary_folder folder;
    const std::string scene =
        "'" + folder.put("a.obj", "v 0 0 0\nv 9 0 0\nv 0 0 9\nf 1 2 3\n").string() + "' --cameras '";
    const auto with = [&](const std::string& fields) {
        return scene + folder.put("a.json", cameras_with(fields)).string() + "'";
    };
    const std::string away = with(R"("eye": [2, 1.9e18, 0], "near": 0.1, "far": 100, "ao_radius": 1)");
    expect_refusal(failure, "the scene begins 1.9e+18 and ends 1.9e+18 away", "reference " + away);
    expect_refusal(failure, "the scene begins 1.9e+18 and ends 1.9e+18 away", "render " + away + hbao);
    const std::string small = with(R"("eye": [2, 1e7, 0], "near": 0.1, "far": 1e8, "ao_radius": 1)");
    expect_refusal(failure, "the radius 1 is out of what 32-bit positions allow", "reference " + small);
    expect_refusal(failure, "the radius 1 is out of what 32-bit positions allow", "render " + small + hbao);
    expect_refusal(failure, "near is 1e-36, and a 32-bit depth buffer",
                   "render " + with(R"("eye": [2, 4, 0], "near": 1e-36, "far": 100, "ao_radius": 1)") + hbao);
    expect_refusal(failure, "\"near\" must be a number, 0 or 1.2e-38 to 3.4e+38 in size",
                   "reference " + with(R"("eye": [2, 4, 0], "near": 1e-50, "far": 100, "ao_radius": 1)"));
}

TEST_CASE("refuses: numbers, with their range") {
    const std::string render = std::string("render built-in") + hbao;
    for (const std::string value : {"nan", "-1", "inf", "1e31", "1x", "''"})
        expect_refusal(usage, "is not a number from 0 to 1e+30", render + " --radius " + value);
    for (const std::string value : {"nan", "0", "-1", "1.5", "x"})
        expect_refusal(usage, "is not a number from 0.001 to 1", "reference glass --opacity " + value);
    for (const std::string value : {"0", "16385", "-1", "1.5", "9999999999", "1e3"})
        expect_refusal(usage, "is not a whole number from 1 to 16384", render + " --width " + value);
    for (const std::string value : {"-1", "4294967296", "x"}) {
        expect_refusal(usage, "is not a whole number from 0 to 4294967295", render + " --frame " + value);
        expect_refusal(usage, "is not a whole number from 0 to 4294967295",
                       "reference built-in --seed " + value);
    }
    expect_refusal(usage, "--shift: 'nan' is not a number from -10 to 10", render + " --shift 0 nan");
    expect_refusal(usage, "is not a number from 1e-38 to 1e+38", "compare a b --depth c --far nan", false);
    expect_refusal(usage, "is not a number from 0 to 1000000", "compare a b --diff c.png --gain nan", false);
    expect_refusal(usage, "strength=nan is out of its range, 0 to 16",
                   "bench --recipes directions/single_layer/hbao@strength=nan", false);
}

TEST_CASE("refuses: options without a use") {
    expect_refusal(usage, "--gain requires --diff", "compare a b --gain 2", false);
    expect_refusal(usage, "--far requires --depth", "compare a b --far 2", false);
    expect_refusal(usage, "--second-camera: the recipe has no second view",
                   std::string("render built-in --second-camera overview") + hbao);
    expect_refusal(usage, "--frame: the recipe has no randomness",
                   "render built-in --frame 1 --recipe sample_box/summed_area/mean_height");
    expect_refusal(usage, "--opacity: the recipe takes every surface for opaque; add /every_layer to it",
                   std::string("render built-in --opacity 0.5") + hbao);
    expect_refusal(failure, "--hull: the scene has no transparent surface; leave it out, or use --opacity",
                   "reference built-in --hull");
    expect_refusal(failure, "--hull: the scene has no transparent surface", "bench built-in --hull", false);
    expect_refusal(usage, "is a recipe and stands among the scenes",
                   "bench --recipes directions/single_layer/hbao directions/single_layer/hbao", false);
}

TEST_CASE("refuses: a projection that the recipe or the depth does not have") {
    expect_refusal(usage,
                   "the recipe has the projection 'orthographic', and the camera 'overview' is perspective",
                   "render built-in --recipe directions/single_layer/hbao/orthographic");
    expect_refusal(usage,
                   "the recipe has the projection 'perspective', and the camera 'overview' is orthographic",
                   "render built-in --orthographic --recipe directions/single_layer/hbao/perspective");
    expect_refusal(failure, "an orthographic camera has no infinite depth",
                   std::string("render built-in --orthographic --depth infinite") + hbao);
    expect_refusal(usage, "--depth", std::string("render built-in --depth linear") + hbao);
}

TEST_CASE("refuses: an output over an input") {
    const temporary_folder folder;
    const std::string pfm = std::string("Pf\n1 1\n-1\n\0\0\0\0", 14);
    const std::string a = folder.put("a.png", pfm).string(), b = folder.put("b.pfm", pfm).string();
    const std::string both = "compare '" + a + "' '" + b + "' --diff ";
    expect_refusal(usage, "'" + a + "' is read by this command", both + "'" + a + "'", false);
    expect_refusal(usage, "'" + b + "' is not the name of a .png file", both + "'" + b + "'", false);
    CHECK(content_of(a) == pfm);
    const std::string scene = folder.put("a.obj", "v 0 0 0\nv 9 0 0\nv 0 0 9\nf 1 2 3\n").string();
    const std::string cameras = cameras_with(R"("eye": [2, 4, 0], "near": 1, "far": 9, "ao_radius": 1)");
    const std::string meta = folder.put("meta.json", cameras).string(), here = (folder / "").string();
    for (const std::string& command : {std::string("render"), std::string("reference")}) {
        const ended done = crease_command(command + " '" + scene + "' --cameras '" + meta + "'" +
                                          (command == "render" ? hbao : "") + " -o '" + here + "'");
        CHECK(done.status == failure);
        CHECK(done.complained.find("meta.json: is read by this command") != std::string::npos);
        CHECK(content_of(meta) == cameras);
        CHECK(folder.files() == 4);
    }
}

TEST_CASE("refuses: what is no command") {
    expect_refusal(usage, "Run crease --help for its arguments", "", false);
    expect_refusal(usage, "Run crease --help for its arguments", "paint", false);
    expect_refusal(usage, "Run crease compare --help for its arguments", "compare a", false);
}

TEST_CASE("refuses: sizes, counts and files") {
    expect_refusal(usage, "--width", std::string("render built-in --width 0") + hbao);
    expect_refusal(usage, "--height", "reference built-in --height 16385");
    expect_refusal(usage, "--rays", "reference built-in --rays 0");
    expect_refusal(usage, "--radius", "reference built-in --radius -1");
    expect_refusal(usage, "--repeats", "bench --repeats 0", false);
    expect_refusal(failure, "missing.pfm: no such file", "compare missing.pfm missing.pfm", false);
    const temporary_folder folder;
    const std::string pfm =
                          "'" + folder.put("a.pfm", std::string("Pf\n1 1\n-1\n\0\0\0\0", 14)).string() + "'",
                      wide = "'" +
                             folder.put("b.pfm", std::string("Pf\n2 1\n-1\n\0\0\0\0\0\0\0\0", 18)).string() +
                             "'";
    expect_refusal(failure, "the test is 1 x 1 x 1 channels, the reference 2 x 1 x 1",
                   "compare " + pfm + " " + wide, false);
    expect_refusal(failure, "cannot read '.png' images; use .pfm or .exr", "compare a.png " + pfm, false);
    CHECK(folder.files() == 2);
}

TEST_CASE("refuses: an output that cannot be a directory") {
    const temporary_folder folder;
    const std::string file = folder.put("file", "kept").string();
    for (const std::string& command : {std::string("emit directions/single_layer/hbao"),
                                       std::string("reference built-in --width 4 --height 4"),
                                       std::string("render built-in --width 4 --height 4") + hbao,
                                       std::string("demo --width 4 --height 4")}) {
        CAPTURE(command);
        const ended done = crease_command(command + " -o '" + file + "'");
        CHECK(done.status == 1);
        CHECK(done.complained.find("cannot make the directory '" + file + "'") != std::string::npos);
    }
    CHECK(content_of(file) == "kept");
    CHECK(folder.files() == 1);
}
