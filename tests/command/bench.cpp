// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <doctest/doctest.h>

#include <cmath>

TEST_CASE("bench: as JSON it holds each recipe, with its passes and views, and keeps the truths") {
    const temporary_folder folder;
    const nlohmann::json whole = nlohmann::json::parse(expect_success(
        "bench built-in --width 64 --height 36 --rays 16 --repeats 2 --hidden --json --truths '" +
        (folder / "truths").string() +
        "' --recipes directions:8x4/single_layer/hbao/bilateral "
        "--recipes directions:8x4/single_layer/hbao/bilateral@strength=0 "
        "--recipes directions:4x4/single_layer/hbao/bent_cone"));
    CHECK(whole.at("width") == 64);
    CHECK(whole.at("height") == 36);
    CHECK_FALSE(whole.at("device").get<std::string>().empty());
    CHECK(whole.at("fetch_loop_milliseconds").get<double>() > 0);
    REQUIRE(whole.at("recipes").size() == 3);
    for (const nlohmann::json& row : whole["recipes"]) {
        CHECK(row.at("milliseconds").get<double>() > 0);
        CHECK(row.at("capture_milliseconds") == 0);
        CHECK(row.at("captures").empty());
        for (const nlohmann::json& pass : row.at("passes")) {
            CHECK(pass.at("fetches").get<unsigned>() > 0);
            CHECK(pass.at("instructions").get<unsigned>() > pass["fetches"].get<unsigned>());
        }
        REQUIRE(row.at("views").size() == 3); // the cameras of the built-in scene
        for (const char* error : {"rmse_hard", "rmse_linear", "rmse_quad", "ssim", "bias", "change"}) {
            double mean = 0;
            for (const nlohmann::json& view : row["views"])
                mean += view.at(error).get<double>() / 3;
            CHECK(std::abs(row.at(error).get<double>() - mean) <= 1e-12);
        }
    }
    const nlohmann::json &drawn = whole["recipes"][0], &nothing = whole["recipes"][1],
                         &bent = whole["recipes"][2];
    CHECK(drawn.at("recipe") == "directions:8x4/single_layer/hbao/bilateral");
    const bool on_processor = whole["device"].get<std::string>().find("llvmpipe") != std::string::npos;
    CHECK(drawn.at("run") == std::string("directions:8x4x2/single_layer/hbao/bilateral:3") +
                                 (on_processor ? "/image_load/compute_columns:16x16x16" : ""));
    CHECK(drawn.at("passes").size() == 3);
    CHECK(drawn["passes"][0].at("fetches").get<unsigned>() >= 32);
    // Without occlusion all is 1: brighter than the truth, and the camera changes nothing.
    CHECK(nothing.at("bias").get<double>() > 0.05);
    CHECK(nothing.at("rmse_linear").get<double>() > drawn.at("rmse_linear").get<double>());
    CHECK(nothing.at("change") == 0);
    CHECK(drawn["views"][0].at("pixels_hidden").get<unsigned>() > 20);
    CHECK(bent["views"][0].at("bent_degrees").get<double>() > 0);
    CHECK_FALSE(drawn["views"][0].contains("bent_degrees"));

    CHECK(files_in(folder / "truths").size() == 3 * 8); // of each camera seven pictures and their list
}

TEST_CASE("bench: an option that may be repeated takes one value each time, and leaves the scene alone") {
    const scene_files scene(true);
    for (const std::string& option : {std::string("--recipes directions:2x2/single_layer/hbao"),
                                      std::string("--set strength=1"), std::string("--cameras above")}) {
        const std::string small = "bench --width 16 --height 9 --rays 1 --repeats 1 --json ";
        const nlohmann::json whole =
            nlohmann::json::parse(expect_success(small + option + " " + scene.scene()));
        CHECK(whole.at("recipes").at(0).at("views").at(0).at("camera") == "above");
    }
}

TEST_CASE("bench: a truth that is kept is of the scene as it is now") {
    const temporary_folder folder;
    const auto bias = [&](const std::string& wall) {
        folder.put("a.obj", "v -50 0 -50\nv 50 0 -50\nv 50 0 50\nv -50 0 50\nf 1 2 3 4\n" + wall);
        folder.put("a.cameras.json",
                   R"([{"name": "a", "eye": [2, 4, 0], "target": [2, 0, 0], "up": [0, 0, -1], "vfov_deg": 40,
                        "near": 0.5, "far": 100, "width": 64, "height": 36, "ao_radius": 2}])");
        const ended done =
            crease_command("bench --width 32 --height 18 --rays 64 --repeats 1 --json --recipes "
                           "directions:2x2/single_layer/hbao@strength=0 '" +
                           (folder / "a.obj").string() + "' --truths '" + (folder / "truths").string() + "'");
        REQUIRE(done.status == 0);
        return std::pair(nlohmann::json::parse(done.said).at("recipes").at(0).at("bias").get<double>(),
                         done.complained);
    };
    CHECK(bias("").first == 0); // what is drawn without strength is open, as a plane is
    const auto walled = bias("v 1 0 -50\nv 1 0 50\nv 1 1 50\nv 1 1 -50\nf 5 6 7 8\n");
    CHECK(walled.first > 0.02);
    CHECK(walled.second.find("are of another scene, camera") != std::string::npos);
    const auto plane = bias("");
    CHECK(plane.first == 0);
    CHECK(plane.second.find("traced anew") == std::string::npos);
}

TEST_CASE("bench: as text it says once what it adds to recipes, and nothing of what they name") {
    const std::string small =
        "bench built-in --width 16 --height 9 --rays 1 --repeats 1 --cameras overview --recipes ";
    const std::string hbao = "directions:2x2/single_layer/hbao/bilateral";
    const std::string text = expect_success(small + hbao + " --recipes " + hbao + "@strength=0");
    const std::string sentence =
        "added to recipes as suits the device and the camera, where they name none of the kind: "
        "/image_load, /compute_columns\n";
    const std::size_t first = text.find(sentence);
    CHECK((first != std::string::npos) == (text.find("llvmpipe") != std::string::npos));
    CHECK((first == std::string::npos || text.find("added to recipes", first + 1) == std::string::npos));
    CHECK(text.find("\n" + hbao + " ") != std::string::npos); // a row is named as it was asked for
    CHECK(expect_success(small + hbao + "/texel_fetch/compute").find("added to recipes") ==
          std::string::npos);
}
