// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <doctest/doctest.h>
#include <png.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <sys/wait.h>

ended crease_command(const std::string& arguments) {
    const temporary_folder folder;
    const std::filesystem::path said = folder / "said", complained = folder / "complained";
    const std::string line = std::string("'" CREASE_COMMAND "' ") + arguments + " >'" + said.string() +
                             "' 2>'" + complained.string() + "'";
    const int raw = std::system(line.c_str());
    return {WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, content_of(said), content_of(complained)};
}

std::string expect_success(const std::string& arguments) {
    const ended done = crease_command(arguments);
    CAPTURE(arguments);
    CAPTURE(done.complained);
    REQUIRE(done.status == 0);
    return done.said;
}

std::set<std::string> files_in(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            names.insert(std::filesystem::relative(entry.path(), folder).generic_string());
    return names;
}

nlohmann::json json_in(const std::filesystem::path& file) {
    return nlohmann::json::parse(content_of(file));
}

written_pictures::written_pictures(const std::string& arguments) {
    expect_success(arguments + " -o '" + (folder / "out").string() + "'");
}

crease::tools::image written_pictures::operator[](const std::string& file) const {
    const crease::tools::image read = crease::tools::read_image(folder / ("out/" + file));
    CHECK(read.width == 64);
    CHECK(read.height == 36);
    return read;
}

std::vector<float> exr_channel_of(const std::filesystem::path& file, const std::string& name) {
    Imf::InputFile input(file.c_str());
    REQUIRE(input.header().channels().findChannel(name) != nullptr);
    const Imath::Box2i window = input.header().dataWindow();
    const int width = window.max.x + 1, height = window.max.y + 1;
    std::vector<float> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    Imf::FrameBuffer target;
    target.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                   sizeof(float) * static_cast<std::size_t>(width)));
    input.setFrameBuffer(target);
    input.readPixels(0, height - 1);
    return values;
}

std::vector<unsigned char> png_of(const std::filesystem::path& file) {
    png_image picture{};
    picture.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_file(&picture, file.c_str()));
    std::vector<unsigned char> bytes(PNG_IMAGE_SIZE(picture));
    REQUIRE(png_image_finish_read(&picture, nullptr, bytes.data(), 0, nullptr));
    return bytes;
}

std::vector<float> channel(const crease::tools::image& of, unsigned first) {
    std::vector<float> values;
    for (std::size_t i = first; i < of.texels.size(); i += of.channels)
        values.push_back(of.texels[i]);
    return values;
}

scene_files::scene_files(bool wall) {
    folder_.put("scene.obj",
                std::string("v -500 0 -500\nv 500 0 -500\nv 500 0 500\nv -500 0 500\nf 1 2 3 4\n") +
                    (wall ? "v 0 0 -500\nv 0 0 500\nv 0 500 500\nv 0 500 -500\nf 5 6 7 8\n" : ""));
    folder_.put("scene.cameras.json",
                R"([{"name": "above", "eye": [2, 4, 0], "target": [2, 0, 0], "up": [0, 0, -1], "vfov_deg": 40,
                     "near": 0.5, "far": 100, "width": 64, "height": 36, "ao_radius": 2}])");
}

std::string scene_files::scene() const {
    return "'" + (folder_ / "scene.obj").string() + "'";
}

std::string scene_files::arguments() const {
    return scene() + " --cameras '" + (folder_ / "scene.cameras.json").string() + "'";
}

double scene_files::x_of(unsigned column) {
    const double to_the_side = height * std::tan(20 * std::numbers::pi / 180) * 64 / 36;
    return 2 + to_the_side * ((column + 0.5) / 32 - 1);
}
