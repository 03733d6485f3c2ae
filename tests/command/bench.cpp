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
        "directions:8x4/single_layer/hbao/bilateral@strength=0 "
        "directions:4x4/single_layer/hbao/bent_cone"));
    CHECK(whole.at("width") == 64);
    CHECK(whole.at("height") == 36);
    CHECK_FALSE(whole.at("device").get<std::string>().empty());
    CHECK(whole.at("fetch_loop_milliseconds").get<double>() > 0);
    REQUIRE(whole.at("recipes").size() == 3);
    for (const nlohmann::json& row : whole["recipes"]) {
        CHECK(row.at("milliseconds").get<double>() > 0);
        CHECK(row.at("capture_milliseconds") == 0);
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

    std::set<std::string> kept;
    for (const std::string& file : files_in(folder / "truths"))
        kept.insert(std::filesystem::path(file).filename().string());
    CHECK(kept ==
          std::set<std::string>{"ao_hard.pfm", "ao_linear.pfm", "ao_quad.pfm", "bent.pfm", "mask.pfm"});
}

TEST_CASE("bench: as text it says once what it adds to recipes, and nothing of what they name") {
    const std::string small =
        "bench built-in --width 16 --height 9 --rays 1 --repeats 1 --cameras overview --recipes ";
    const std::string hbao = "directions:2x2/single_layer/hbao/bilateral";
    const std::string text = expect_success(small + hbao + " " + hbao + "@strength=0");
    const std::string sentence = "added to recipes as suits the device, where they name none of the kind: "
                                 "/image_load, /compute_columns\n";
    const std::size_t first = text.find(sentence);
    CHECK((first != std::string::npos) == (text.find("llvmpipe") != std::string::npos));
    CHECK((first == std::string::npos || text.find("added to recipes", first + 1) == std::string::npos));
    CHECK(text.find("\n" + hbao + " ") != std::string::npos); // a row is named as it was asked for
    CHECK(expect_success(small + hbao + "/texel_fetch/compute").find("added to recipes") ==
          std::string::npos);
}
