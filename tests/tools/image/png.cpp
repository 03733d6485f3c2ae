// SPDX-License-Identifier: MIT
#include "image/image.hpp"

#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <png.h>

#include <cstdint>
#include <limits>

using namespace crease::tools;

namespace {

std::vector<std::uint8_t> bytes_of(const std::filesystem::path& path, png_uint_32 format) {
    png_image picture{};
    picture.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_file(&picture, path.c_str()));
    CHECK(picture.format == format);
    std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(picture));
    REQUIRE(png_image_finish_read(&picture, nullptr, bytes.data(), 0, nullptr));
    return bytes;
}

}

TEST_CASE("png: values times 255, clamped and rounded, row 0 first") {
    const temporary_folder folder;
    image grey(4, 2);
    grey.texels = {0, 1, 0.5f, 0.1f, -3, 7, std::numeric_limits<float>::quiet_NaN(), 1e-9f};
    write_png(folder / "grey.png", grey);
    CHECK(bytes_of(folder / "grey.png", PNG_FORMAT_GRAY) ==
          std::vector<std::uint8_t>{0, 255, 128, 26, 0, 255, 0, 0});

    image rgb(1, 2, 3);
    rgb.texels = {0, 0.2f, 0.4f, 0.6f, 0.8f, 1};
    write_png(folder / "rgb.png", rgb);
    CHECK(bytes_of(folder / "rgb.png", PNG_FORMAT_RGB) ==
          std::vector<std::uint8_t>{0, 51, 102, 153, 204, 255});
}

TEST_CASE("png: what cannot be written") {
    const temporary_folder folder;
    expect_error<image_error>("1 or 3 channels", [&] { write_png(folder / "a.png", image(1, 1, 4)); });
    expect_error<image_error>("cannot make the PNG", [&] { write_png(folder / "a.png", image(0, 0)); });
    CHECK(folder.files() == 0);
}
