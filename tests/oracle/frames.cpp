// SPDX-License-Identifier: MIT
// Whole images of frames other than 0: the noise of a pixel is another one, and as the oracle has it.
#include "run.hpp"
#include "techniques.hpp"

#include <doctest/doctest.h>

#include <memory>

TEST_CASE("every frame has noise of its own, hashed or tiled") {
    const oracle::picture p = oracle::draw(oracle::still_life(), oracle::lens::standard, 97, 61);
    for (const oracle::technique& t : oracle::techniques())
        for (const char* noise : {"", "/tiled_noise", "/tiled_noise:3"}) {
            CAPTURE(t.recipe());
            CAPTURE(std::string(noise));
            const auto composed = oracle::compose(t.recipe() + noise);
            crease::parameters how = oracle::view_parameters(p, *composed, 0.5);
            const std::vector<float> first = oracle::run(p, *composed, how);
            for (std::uint32_t frame : {1u, 2u, 1000u}) {
                CAPTURE(frame);
                how.frame = frame;
                oracle::settings s = oracle::settings_of(how, *composed);
                s.tile = *noise == 0 ? 0 : noise[std::string(noise).size() - 1] == '3' ? 3 : 4;
                const auto expected = oracle::main_pass(
                    p, s, 1, false, [&](const oracle::receiver& r) { return t.occlusion(p, r, s); });
                const std::vector<float> image = oracle::run(p, *composed, how);
                oracle::check_within(oracle::compare(image, expected), oracle::of_rounding);
                std::size_t other = 0;
                for (std::size_t i = 0; i < image.size(); ++i)
                    other += image[i] != first[i];
                CHECK(other > image.size() / 8);
            }
        }
}
