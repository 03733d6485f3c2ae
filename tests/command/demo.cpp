// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <doctest/doctest.h>

TEST_CASE("demo: a sheet, and pictures, GLSL, SPIR-V and figures of each recipe") {
    const temporary_folder folder;
    const std::string said =
        expect_success("demo --width 64 --height 36 --rays 16 -o '" + (folder / "out").string() + "'");
    CHECK(said.find("begin with sheet.png") != std::string::npos);
    const std::set<std::string> files = files_in(folder / "out");
    CHECK(files.contains("sheet.png"));
    CHECK(png_of(folder / "out/truth.png").size() == 64 * 36);
    const nlohmann::json figures = json_in(folder / "out/figures.json");
    std::size_t pictures = 0, glsl = 0, spirv = 0;
    for (const std::string& file : files) {
        pictures += file.ends_with("/ao.png");
        glsl += file.ends_with("/0_visibility.comp");
        spirv += file.ends_with("/0_visibility.comp.spv");
        if (file.ends_with("/ao.png"))
            CHECK(png_of(folder / ("out/" + file)).size() == 64 * 36);
    }
    CHECK(pictures == figures.size());
    CHECK(glsl == figures.size());
    CHECK(spirv == figures.size());
    REQUIRE(figures.size() >= 3);
    for (const nlohmann::json& figure : figures) {
        CHECK(figure.at("recipe").is_string());
        CHECK(figure.at("milliseconds").get<double>() > 0);
        CHECK(figure.at("rmse").get<double>() > 0);
        CHECK(figure.at("rmse").get<double>() < 0.25);
        CHECK(figure.at("ssim").get<double>() > 0.1);
        CHECK(figure.at("ssim").get<double>() < 1);
        CHECK(figure.at("bias").is_number());
    }
}
