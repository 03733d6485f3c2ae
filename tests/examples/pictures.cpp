// SPDX-License-Identifier: MIT
// The pictures that the examples wrote are those that the runner makes of the same recipes and scene.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "camera.hpp"

#include <crease/crease.hpp>
#include <crease/vulkan.hpp>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace {

std::vector<int> read_pgm(const std::string& name) {
    std::ifstream file(CREASE_EXAMPLE_PICTURES "/" + name + ".pgm", std::ios::binary);
    REQUIRE_MESSAGE(file.is_open(), name);
    std::string magic;
    unsigned width = 0, height = 0, most = 0;
    file >> magic >> width >> height >> most;
    file.get();
    REQUIRE((magic == "P5" && width == picture::width && height == picture::height && most == 255));
    std::vector<int> texels;
    for (std::istreambuf_iterator<char> at(file), end; at != end; ++at)
        texels.push_back(static_cast<unsigned char>(*at));
    REQUIRE(texels.size() == picture::width * picture::height);
    return texels;
}

std::vector<std::uint8_t> by_runner(std::string_view recipe_text) {
    static crease::vulkan::device device;
    const auto composed = std::make_unique<crease::composition>(crease::recipe(recipe_text));
    REQUIRE(*composed);
    crease::vulkan::runner runner(device, composed->view(), picture::width, picture::height);
    runner.upload("depth", camera::depth());
    runner.run(camera::parameters_for(composed->view()));
    return picture::bytes_of(runner.download("visibility"));
}

/// How many texels differ by more than a step of r8.
std::size_t others(const std::vector<int>& seen, const std::vector<std::uint8_t>& expected) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < seen.size(); ++i)
        count += std::abs(seen[i] - expected.at(i)) > 1;
    return count;
}

constexpr std::string_view alone = "directions:4x4/single_layer/hbao/reconstructed_normals";

}

TEST_CASE("an example's picture is the runner's") {
    const std::pair<const char*, std::string> pictures[] = {
        {"runner", std::string(alone) + "/bilateral"},
        {"vulkan_host", std::string(alone)},
        {"half_resolution", std::string(alone) + "/bilateral/upsample:2"},
        {"functions_in_a_shader", std::string(alone)},
        {"recipe_switch_0", std::string(alone)},
        {"recipe_switch_2", "poisson_disk:16/single_layer/hbao_plus/reconstructed_normals/bilateral"},
        {"recipe_switch_3", std::string(alone) + "/fragment/upsample:2"}};
    for (const std::pair<const char*, std::string>& each : pictures) {
        INFO(each.first);
        CHECK(others(read_pgm(each.first), by_runner(each.second)) == 0);
    }
}

TEST_CASE("a left-handed host sees the same picture, but for the rounding of its depth") {
    CHECK(others(read_pgm("left_handed_host"), by_runner(alone)) < picture::width * picture::height / 1000);
}

TEST_CASE("two recipes make two pictures, so that equal ones say something") {
    CHECK(others(read_pgm("vulkan_host"), by_runner(std::string(alone) + "/bilateral")) > 1000);
    CHECK(others(read_pgm("recipe_switch_0"), by_runner(std::string(alone) + "/fragment/upsample:2")) > 1000);
}
