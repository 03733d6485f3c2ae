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

TEST_CASE("pfm: lines that end in CR LF") {
    const std::string values("\0\0\x80\x3f\n\0\0\xc0", 8); // the last one's first byte is a line end
    const image pixels = parse_pfm("Pf\r\n1 2\r\n-1.0\r\n" + values, "memory");
    CHECK(pixels.at(0, 1) == 1);
    CHECK(pixels.at(0, 0) == -2.0000023841857910f);
    // CR alone may end the header too, before a value whose first byte is LF.
    CHECK(parse_pfm("Pf\r1 1\r-1.0\r" + values.substr(4), "memory").at(0, 0) == -2.0000023841857910f);
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
    expect("truncated: 1 x 1 x 1 floats are 4 bytes, the file has 3", "Pf\r\n1 1\r\n-1\r\nabc");
    expect("1 x 1 x 1 floats are 4 bytes, and 1 more follow them", "Pf\n1 1\n-1\nabcde");
    expect("1 x 1 x 1 floats are 4 bytes, and 1 more follow them", "Pf\r\n1 1\r\n-1\r\nabcde");
    for (const std::string scale : {"nan", "-nan", "inf", "-inf", "-1e99", "-1x"})
        expect("broken PFM header", "Pf\n1 1\n" + scale + "\nabcd");
}

TEST_CASE("image: an extension in letters of either case") {
    const temporary_folder folder;
    write_pfm(folder / "a.PFM", image(1, 1));
    CHECK(read_image(folder / "a.PFM").width == 1);
}

TEST_CASE("image: what cannot be read or written") {
    const temporary_folder folder;
    expect_error<image_error>("cannot read '.png' images; use .pfm or .exr",
                              [&] { read_image(folder / "a.png"); });
    expect_error<image_error>("PFM holds 1 or 3 channels, not 2",
                              [&] { write_pfm(folder / "a.pfm", image(1, 1, 2)); });
    CHECK(folder.files() == 0);
}
