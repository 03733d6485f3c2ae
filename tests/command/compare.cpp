// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <doctest/doctest.h>

#include <cmath>

using crease::tools::image;

namespace {

/// Pictures of 4 x 1 in a folder: one, its reference and its depth.
struct pictures {
    temporary_folder folder;

    pictures() {
        put("test", {0, 0.5f, 1, 0.25f});
        put("reference", {0, 0, 0.5f, 0.5f});
        put("depth", {1, 1, 2, 9});
    }

    std::string operator()(const std::string& name) const { return "'" + (folder / name).string() + "'"; }

private:
    void put(const std::string& name, const std::vector<float>& values) {
        image made(4, 1);
        made.texels = values;
        write_pfm(folder / (name + ".pfm"), made);
    }
};

}

TEST_CASE("compare: numbers as JSON, and a picture of the difference") {
    const pictures p;
    const nlohmann::json all = nlohmann::json::parse(expect_success(
        "compare " + p("test.pfm") + " " + p("reference.pfm") + " --json --gain 2 --diff " + p("d.png")));
    CHECK(all.at("pixels") == 4);
    CHECK(all.at("background") == 0);
    CHECK(all.at("nonfinite") == 0);
    CHECK(all.at("rmse") == 0.375); // differences 0, 1/2, 1/2, -1/4: mean square 9/64
    CHECK(all.at("mae") == 0.3125);
    CHECK(all.at("bias") == 0.1875);
    CHECK(all.at("max_abs") == 0.5);
    CHECK(std::abs(all.at("psnr_db").get<double>() - 20 * std::log10(1 / 0.375)) <= 1e-12);
    CHECK(all.at("p99_abs") == 0.5);
    CHECK(all.at("ssim").is_null()); // no 8 x 8 window
    CHECK(png_of(p.folder / "d.png") == std::vector<unsigned char>{0, 255, 255, 128});
}

TEST_CASE("compare: what is far is left out") {
    const pictures p;
    const std::string both =
        "compare " + p("test.pfm") + " " + p("reference.pfm") + " --json --depth " + p("depth.pfm");
    const nlohmann::json deepest = nlohmann::json::parse(expect_success(both)),
                         far = nlohmann::json::parse(expect_success(both + " --far 2"));
    CHECK(deepest.at("background") == 1);
    CHECK(deepest.at("pixels") == 3);
    CHECK(far.at("background") == 2);
    CHECK(far.at("bias") == 0.25);
}

TEST_CASE("compare: a file of lines in CR LF is the same picture") {
    const pictures p;
    std::string bytes = content_of(p.folder / "test.pfm");
    for (std::size_t at = 0, line = 0; line < 3; ++line, at += 2)
        bytes.insert(at = bytes.find('\n', at), "\r");
    p.folder.put("crlf.pfm", bytes);
    const nlohmann::json same =
        nlohmann::json::parse(expect_success("compare " + p("crlf.pfm") + " " + p("test.pfm") + " --json"));
    CHECK(same.at("max_abs") == 0);
    p.folder.put("longer.pfm", content_of(p.folder / "test.pfm") + "x");
    const ended longer = crease_command("compare " + p("longer.pfm") + " " + p("test.pfm"));
    CHECK(longer.status == 1);
    CHECK(longer.complained.find("and 1 more follow them") != std::string::npos);
}

TEST_CASE("compare: as text it has a line of each number") {
    const pictures p;
    const std::string text = expect_success("compare " + p("test.pfm") + " " + p("reference.pfm"));
    CHECK(
        text ==
        "pixels       4\nbackground   0\nnonfinite    0\nrmse         0.375\nmae          0.3125\n"
        "bias         0.1875\npsnr_db      8.51937\nssim         nan\np99_abs      0.5\nmax_abs      0.5\n");
}
