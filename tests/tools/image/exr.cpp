// SPDX-License-Identifier: MIT
#include "image/image.hpp"

#include "expect_error.hpp"
#include "temporary_folder.hpp"

using namespace crease::tools;

namespace {

image ramp(unsigned width, unsigned height, unsigned channels) {
    image pixels(width, height, channels);
    for (std::size_t i = 0; i < pixels.texels.size(); ++i)
        pixels.texels[i] = 0.3f * static_cast<float>(i);
    return pixels;
}

}

TEST_CASE("exr: a round trip keeps every bit, among other channels") {
    const temporary_folder folder;
    const image visibility = ramp(37, 21, 1), normal = ramp(37, 21, 3), depth(37, 21, 1, 2.5f);
    const exr_channel all[] = {{"visibility", visibility},
                               {"depth.Z", depth},
                               {"normal.X", normal, 0},
                               {"normal.Y", normal, 1},
                               {"normal.Z", normal, 2}};
    write_exr(folder / "a.exr", all);
    const image read = read_image(folder / "a.exr");
    CHECK(read.width == 37);
    CHECK(read.height == 21);
    CHECK(read.channels == 1);
    CHECK(read.texels == visibility.texels);

    // Y goes before visibility, and R, G, B before both.
    const exr_channel with_y[] = {{"visibility", visibility}, {"Y", depth}};
    write_exr(folder / "a.exr", with_y);
    CHECK(read_exr(folder / "a.exr").texels == depth.texels);
    const exr_channel with_rgb[] = {{"Y", depth}, {"R", normal, 0}, {"G", normal, 1}, {"B", normal, 2}};
    write_exr(folder / "a.exr", with_rgb);
    CHECK(read_exr(folder / "a.exr").texels == normal.texels);
}

TEST_CASE("exr: broken files") {
    const temporary_folder folder;
    const image pixels = ramp(64, 64, 1);
    const exr_channel other[] = {{"depth.Z", pixels}};
    write_exr(folder / "other.exr", other);
    expect_error<image_error>("it has: depth.Z", [&] { read_exr(folder / "other.exr"); });

    const exr_channel good[] = {{"Y", pixels}};
    write_exr(folder / "good.exr", good);
    const std::string bytes = content_of(folder / "good.exr");
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{7}, bytes.size() / 8, bytes.size() / 2, bytes.size() - 1}) {
        CAPTURE(size);
        const std::filesystem::path cut = folder.put("cut.exr", bytes.substr(0, size));
        expect_error<image_error>("cut.exr: broken or unsupported EXR file", [&] { read_exr(cut); });
    }
    // The window is four little-endian ints after its name, type and size; the third is the largest x.
    std::string huge = bytes;
    const std::size_t window = huge.find("dataWindow") + sizeof("dataWindow") + sizeof("box2i") + 4;
    huge.replace(window + 8, 4, "\xff\xff\xff\x0f");
    expect_error<image_error>("huge.exr: ", [&] { read_exr(folder.put("huge.exr", huge)); });
}

TEST_CASE("exr: its table says where lines are, so what else is in the file does not matter") {
    const temporary_folder folder;
    const image pixels = ramp(64, 64, 1);
    const exr_channel channels[] = {{"Y", pixels}};
    write_exr(folder / "good.exr", channels);
    const std::string bytes = content_of(folder / "good.exr");
    CHECK(read_exr(folder.put("more.exr", bytes + "more")).texels == pixels.texels);
}

TEST_CASE("exr: channels that do not fit together are not written") {
    const temporary_folder folder;
    const image pixels(4, 4), smaller(4, 3);
    expect_error<image_error>("needs at least one channel", [&] { write_exr(folder / "a.exr", {}); });
    const exr_channel sizes[] = {{"Y", pixels}, {"Z", smaller}};
    expect_error<image_error>("channel 'Z'", [&] { write_exr(folder / "a.exr", sizes); });
    const exr_channel components[] = {{"Y", pixels, 1}};
    expect_error<image_error>("channel 'Y'", [&] { write_exr(folder / "a.exr", components); });
    CHECK(folder.files() == 0);
}
