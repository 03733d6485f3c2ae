// SPDX-License-Identifier: MIT
#include "image/image.hpp"

#include "expect_error.hpp"
#include "temporary_folder.hpp"

#include <cmath>
#include <limits>

using namespace crease::tools;

TEST_CASE("pfm: the bytes of a small file") {
    const temporary_folder folder;
    image pixels(1, 2);
    pixels.at(0, 0) = 1;  // 0x3f800000
    pixels.at(0, 1) = -2; // 0xc0000000
    write_pfm(folder / "a.pfm", pixels);
    CHECK(content_of(folder / "a.pfm") == std::string("Pf\n1 2\n-1.0\n\0\0\0\xc0\0\0\x80\x3f", 20));
}

TEST_CASE("pfm: a round trip keeps every bit") {
    const temporary_folder folder;
    for (const unsigned channels : {1u, 3u}) {
        image pixels(5, 3, channels);
        for (std::size_t i = 0; i < pixels.texels.size(); ++i)
            pixels.texels[i] = 0.1f * static_cast<float>(i);
        pixels.texels[2] = std::numeric_limits<float>::infinity();
        write_pfm(folder / "a.pfm", pixels);
        const image read = read_image(folder / "a.pfm");
        CHECK(read.width == 5);
        CHECK(read.height == 3);
        CHECK(read.channels == channels);
        CHECK(read.texels == pixels.texels);
    }
}

TEST_CASE("pfm: big-endian, odd white space, NaN") {
    const image pixels =
        parse_pfm(std::string_view("Pf 2\t1\r\n1.0\n\x3f\x80\0\0\x7f\xc0\0\0", 20), "memory");
    CHECK(pixels.at(0, 0) == 1);
    CHECK(std::isnan(pixels.at(1, 0)));
}

TEST_CASE("pfm: broken files") {
    const auto expect = [](const std::string& part, std::string_view bytes) {
        expect_error<image_error>("memory: " + part, [&] { parse_pfm(bytes, "memory"); });
    };
    expect("not a PFM file", "");
    expect("not a PFM file", "P5\n1 1\n255\n ");
    expect("broken PFM header", "Pf");
    expect("broken PFM header", "Pf\n1 one\n-1\n");
    expect("broken PFM header", "Pf\n-1 1\n-1\n");
    expect("broken PFM header", "Pf\n1 1\n0\nabcd");
    expect("broken PFM header", "Pf\n1 1\n-1");
    expect("broken PFM header", "Pf\n99999999999 1\n-1\n");
    expect("0 x 1 texels", "Pf\n0 1\n-1\nabcd");
    expect("1 x 16385 texels", "Pf\n1 16385\n-1\nabcd");
    expect("truncated", "Pf\n16384 16384\n-1\nabcd");
    expect("truncated", "PF\n1 1\n-1\nabcdefghijk");
}

TEST_CASE("image: what cannot be read or written") {
    const temporary_folder folder;
    expect_error<image_error>("cannot read '.png' images; use .pfm or .exr",
                              [&] { read_image(folder / "a.png"); });
    expect_error<image_error>("PFM holds 1 or 3 channels, not 2",
                              [&] { write_pfm(folder / "a.pfm", image(1, 1, 2)); });
    CHECK(folder.files() == 0);
}
