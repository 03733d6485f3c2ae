// SPDX-License-Identifier: MIT
// Whole images of frames other than 0: the noise of a pixel is another one, and as the oracle has it.
#include "run.hpp"
#include "techniques.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string_view>

namespace {

void check_frames(const oracle::technique& t, const std::string& noise) {
    CAPTURE(t.recipe());
    CAPTURE(noise);
    const oracle::picture p = oracle::draw(oracle::still_life(), oracle::lens::standard, 97, 61);
    const auto composed = oracle::compose(t.recipe() + "/" + noise);
    crease::parameters how = oracle::view_parameters(p, *composed, 0.5);
    const std::vector<float> first = oracle::run(p, *composed, how);
    const bool has_noise =
        std::ranges::any_of(composed->view().passes[0].pieces, [](const crease::piece& each) {
            return each.text.find("crease_noise(") != std::string_view::npos;
        });
    for (std::uint32_t frame : {1u, 2u, 1000u}) {
        CAPTURE(frame);
        how.frame = frame;
        oracle::settings s = oracle::settings_of(how, *composed);
        s.noise = noise;
        const auto expected = oracle::main_pass(
            p, s, 1, false, [&](const oracle::receiver& r) { return t.occlusion(p, r, s); });
        const std::vector<float> image = oracle::run(p, *composed, how);
        oracle::check_within(oracle::compare(image, expected), oracle::of_rounding);
        std::size_t other = 0;
        for (std::size_t i = 0; i < image.size(); ++i)
            other += image[i] != first[i];
        if (has_noise)
            CHECK(other > image.size() / 8);
        else
            CHECK(other == 0);
    }
}

}

TEST_CASE("every frame has noise of its own, hashed or tiled") {
    for (const oracle::technique& t : oracle::techniques())
        for (const char* noise : {"hashed_noise", "tiled_noise", "tiled_noise:3"})
            check_frames(t, noise);
}

TEST_CASE("every frame has noise of its own, by a gradient, along a curve or from a tile") {
    for (const char* noise : {"interleaved_gradient_noise", "hilbert_r2_noise", "blue_noise"})
        check_frames(oracle::techniques()[1], noise);
}
