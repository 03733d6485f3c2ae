// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <doctest/doctest.h>

namespace {

/// Expects that the command fails, says `sentence`, and writes nothing.
void expect_refusal(const std::string& sentence, const std::string& arguments, bool takes_output = true) {
    const temporary_folder folder;
    const ended done =
        crease_command(arguments + (takes_output ? " -o '" + (folder / "out").string() + "'" : ""));
    CAPTURE(arguments);
    CAPTURE(done.complained);
    CHECK(done.status > 0);
    CHECK(done.status < 128); // by a signal it would be more
    CHECK(done.complained.find(sentence) != std::string::npos);
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
    expect_refusal("no part of the name 'nothing'", "emit nothing/single_layer/hbao");
    expect_refusal("needs taps in order along directions", "emit poisson_disk/single_layer/hbao");
    expect_refusal("SPIR-V can be emitted of programs in the vulkan dialect only",
                   "emit directions/single_layer/hbao --dialect opengl --format spirv");
    expect_refusal("'1a' is no C++ identifier",
                   "emit directions/single_layer/hbao --format header --name 1a");
    expect_refusal("no part of the name 'nothing'", "render built-in --recipe nothing/single_layer/hbao");
    expect_refusal("a recipe that is run is of programs in the vulkan dialect",
                   "render built-in --recipe directions/single_layer/hbao/opengl");
    expect_refusal("no part of the name 'nothing'", "bench --recipes nothing/single_layer/hbao", false);
}

TEST_CASE("refuses: settings") {
    const std::string render = std::string("render built-in") + hbao;
    expect_refusal("no part of this recipe has the setting 'colour'; there are hbao.bias, ",
                   render + " --set colour=1");
    expect_refusal("--set bias=x: it must read name=number", render + " --set bias=x");
    expect_refusal("--set bias: it must read name=number", render + " --set bias");
    expect_refusal("strength=-1 is out of its range, 0 to 16", render + " --set strength=-1");
    expect_refusal("no part of this recipe has the setting 'hbao_plus.bias'",
                   render + " --set hbao_plus.bias=0");
    expect_refusal("hbao.bias=2 is out of its range, 0 to 1.5", render + " --set hbao.bias=2");
    expect_refusal("bias=2 is out of its range, 0 to 1.5", render + " --set bias=2");
    expect_refusal("strength=nan is out of its range, 0 to 16", render + " --set strength=nan");
    expect_refusal("it must read name=number", "bench --recipes directions/single_layer/hbao@bias", false);
}

TEST_CASE("refuses: scenes, cameras and devices") {
    expect_refusal("missing.glb: no such file",
                   std::string("render missing.glb --cameras missing.json") + hbao);
    expect_refusal("missing.glb: no such file", "reference missing.glb --cameras missing.json");
    expect_refusal("missing.glb: no such file", "bench missing.glb", false);
    expect_refusal("there is no camera 'nowhere'; there are: overview, ",
                   std::string("render built-in --camera nowhere") + hbao);
    expect_refusal("there is no camera 'nowhere'", "reference built-in --camera nowhere");
    expect_refusal("none of the scenes has a camera that --cameras names", "bench --cameras nowhere", false);
    expect_refusal("there is no camera 'nowhere'",
                   std::string("render built-in --second-camera nowhere") + hbao);
    for (const std::string& command : {std::string("render built-in") + hbao, std::string("demo")})
        expect_refusal("no Vulkan device named 'abacus'", command + " --device abacus");
    expect_refusal("no Vulkan device named 'abacus'", "bench --device abacus", false);
    const temporary_folder folder;
    const std::string scene =
        "'" + folder.put("a.obj", "v 0 0 0\nv 9 0 0\nv 0 0 9\nf 1 2 3\n").string() + "'";
    expect_refusal("--cameras is missing", "reference " + scene);
}

TEST_CASE("refuses: eyes and depths that 32 bits cannot hold") {
    const temporary_folder folder;
    const std::string scene =
        "'" + folder.put("a.obj", "v 0 0 0\nv 9 0 0\nv 0 0 9\nf 1 2 3\n").string() + "' --cameras '";
    const auto with = [&](const std::string& fields) {
        return scene + folder.put("a.json", cameras_with(fields)).string() + "'";
    };
    const std::string away = with(R"("eye": [2, 1.9e18, 0], "near": 0.1, "far": 100, "ao_radius": 1)");
    expect_refusal("the scene begins 1.9e+18 and ends 1.9e+18 away", "reference " + away);
    expect_refusal("the scene begins 1.9e+18 and ends 1.9e+18 away", "render " + away + hbao);
    const std::string small = with(R"("eye": [2, 1e7, 0], "near": 0.1, "far": 1e8, "ao_radius": 1)");
    expect_refusal("the radius 1 is out of what 32-bit positions allow", "reference " + small);
    expect_refusal("the radius 1 is out of what 32-bit positions allow", "render " + small + hbao);
    expect_refusal("near is 1e-36, and a 32-bit depth buffer",
                   "render " + with(R"("eye": [2, 4, 0], "near": 1e-36, "far": 100, "ao_radius": 1)") + hbao);
    expect_refusal("\"near\" must be a number, 0 or 1.2e-38 to 3.4e+38 in size",
                   "reference " + with(R"("eye": [2, 4, 0], "near": 1e-50, "far": 100, "ao_radius": 1)"));
}

TEST_CASE("refuses: sizes, counts and files") {
    expect_refusal("--width", std::string("render built-in --width 0") + hbao);
    expect_refusal("--height", "reference built-in --height 16385");
    expect_refusal("--rays", "reference built-in --rays 0");
    expect_refusal("--radius", "reference built-in --radius -1");
    expect_refusal("--repeats", "bench --repeats 0", false);
    expect_refusal("missing.pfm: no such file", "compare missing.pfm missing.pfm", false);
    const temporary_folder folder;
    const std::string pfm =
                          "'" + folder.put("a.pfm", std::string("Pf\n1 1\n-1\n\0\0\0\0", 14)).string() + "'",
                      wide = "'" +
                             folder.put("b.pfm", std::string("Pf\n2 1\n-1\n\0\0\0\0\0\0\0\0", 18)).string() +
                             "'";
    expect_refusal("the test is 1 x 1 x 1 channels, the reference 2 x 1 x 1", "compare " + pfm + " " + wide,
                   false);
    expect_refusal("cannot read '.png' images; use .pfm or .exr", "compare a.png " + pfm, false);
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
