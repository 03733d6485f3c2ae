// SPDX-License-Identifier: MIT
// Whole images of the shaders against the oracle's.
//
// Tolerances: visibility is stored in 8 bits, so 0.5 / 255 on top of the arithmetic. Where the coordinates of
// a tap lie on a texel's edge, single and double precision pick different texels; that moves a few pixels by
// one tap's share, so the bounds are on the 99th percentile and on the mean.
#include "run.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <memory>

namespace {

using oracle::lens;

struct technique {
    std::string recipe;
    std::function<double(const oracle::picture&, const oracle::receiver&, const oracle::settings&)> occlusion;
};

const std::vector<technique>& techniques() {
    static const std::vector<technique> all{
        {"hemisphere_points:12/single_layer/ssao",
         [](const auto& p, const auto& r, const auto& s) {
             return oracle::ssao(p, r, s, oracle::hemisphere_points(p, r, s, 12));
         }},
        {"directions:6x3/single_layer/hbao",
         [](const auto& p, const auto& r, const auto& s) {
             return oracle::hbao(p, r, s, oracle::directions(p, r, s, 6, 3));
         }},
        {"directions:6x3/single_layer/hbao_plus",
         [](const auto& p, const auto& r, const auto& s) {
             return oracle::hbao_plus(p, r, s, oracle::directions(p, r, s, 6, 3));
         }},
        {"poisson_disk:12/single_layer/hbao_plus",
         [](const auto& p, const auto& r, const auto& s) {
             return oracle::hbao_plus(p, r, s, oracle::poisson_disk(p, r, s, 12));
         }},
    };
    return all;
}

/// Runs a technique with further parts on both sides, and compares.
oracle::difference
differ(const technique& t, const std::string& parts, lens kind, bool reconstructed,
       const std::function<oracle::visibility_image(const oracle::visibility_image&, const oracle::picture&,
                                                    const oracle::settings&)>& filter = {},
       int divisor = 1) {
    const oracle::picture p = oracle::draw(oracle::still_life(), kind, 97, 61);
    const std::string text = t.recipe + parts + (kind == lens::orthographic ? "/orthographic" : "") +
                             (reconstructed ? "/reconstructed_normals" : "");
    const crease::recipe chosen{std::string_view(text)};
    REQUIRE_MESSAGE(static_cast<bool>(chosen), chosen.error());
    const auto composed = std::make_unique<crease::composition>(chosen);
    const crease::parameters how = oracle::view_parameters(p, composed->view(), 0.5);
    const oracle::settings s = oracle::settings_of(how);
    oracle::visibility_image expected = oracle::main_pass(
        p, s, divisor, reconstructed, [&](const oracle::receiver& r) { return t.occlusion(p, r, s); });
    if (filter)
        expected = filter(expected, p, s);
    return oracle::compare(oracle::run(p, composed->view(), how), expected.visibility);
}

constexpr double one_step = 1.0 / 255;

}

TEST_CASE("every estimator and sampler, in every projection") {
    for (const technique& t : techniques())
        for (lens kind :
             {lens::standard, lens::reversed, lens::infinite, lens::off_centre, lens::orthographic}) {
            CAPTURE(t.recipe);
            CAPTURE(static_cast<int>(kind));
            const oracle::difference d = differ(t, "", kind, false);
            CHECK(d.typical < 0.02);
            CHECK(d.mean < 0.6 * one_step);
        }
}

TEST_CASE("reconstructed normals, linear and linearised depth, and the fragment stage") {
    for (const technique& t : techniques()) {
        CAPTURE(t.recipe);
        CHECK(differ(t, "", lens::standard, true).mean < one_step);
        CHECK(differ(t, "/linear_depth", lens::standard, false).mean < 0.6 * one_step);
        CHECK(differ(t, "/fragment", lens::standard, false).mean < 0.6 * one_step);
        CHECK(differ(t, "/fragment/linear_depth", lens::orthographic, true).mean < one_step);
        CHECK(differ(t, "/linearised_depth", lens::reversed, false).mean < 0.6 * one_step);
        CHECK(differ(t, "/fragment/linearised_depth", lens::orthographic, true).mean < one_step);
    }
}

TEST_CASE("the bilateral filter") {
    for (int radius : {1, 4}) {
        CAPTURE(radius);
        const auto blur = [radius](const auto& image, const auto&, const auto& s) {
            return oracle::bilateral(image, s, radius);
        };
        const oracle::difference d =
            differ(techniques()[1], "/bilateral:" + std::to_string(radius), lens::standard, false, blur);
        CHECK(d.typical < 0.02);
        CHECK(d.mean < one_step);
    }
}

TEST_CASE("upsampling from half, third and quarter resolution") {
    for (int factor : {2, 3, 4}) {
        CAPTURE(factor);
        const auto enlarge = [factor](const auto& image, const auto& p, const auto& s) {
            return oracle::upsample(image, p, s, factor);
        };
        const oracle::difference d = differ(techniques()[1], "/upsample:" + std::to_string(factor),
                                            lens::standard, false, enlarge, factor);
        CHECK(d.typical < 0.02);
        CHECK(d.mean < one_step);
    }
}

TEST_CASE("half and quarter resolution along creases at a slant come near the whole one") {
    // Two walls and a floor whose creases cross the rows and columns of the picture at small angles.
    const glm::dvec3 floor = glm::normalize(glm::dvec3(0.12, 1, 0.5)),
                     wall = glm::normalize(glm::cross(floor, glm::dvec3(1, 0.1, 0.3))),
                     side = glm::cross(floor, wall);
    using kind = oracle::surface::kind;
    const glm::dvec3 corner(0.4, -0.3, -4);
    const oracle::picture p =
        oracle::draw({{kind::plane, corner, floor}, {kind::plane, corner, wall}, {kind::plane, corner, side}},
                     lens::standard, 321, 203);
    const std::vector<float> whole = oracle::run(p, "directions:8x8/single_layer/hbao/bilateral", 0.8);
    for (const auto& [filters, bound] :
         {std::pair{"/bilateral:1/upsample:2", 0.0105}, {"/bilateral:1/upsample:4", 0.018}}) {
        const std::vector<float> coarse =
            oracle::run(p, std::string("directions:8x8/single_layer/hbao") + filters, 0.8);
        double squares = 0, least = 1;
        for (std::size_t i = 0; i < whole.size(); ++i) {
            squares += (whole[i] - coarse[i]) * double{whole[i] - coarse[i]};
            least = std::min(least, double{whole[i]});
        }
        CAPTURE(std::string(filters));
        CHECK(least < 0.6);
        CHECK(std::sqrt(squares / static_cast<double>(whole.size())) < bound);
    }
}

TEST_CASE("strength and exponent") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 64, 48);
    const crease::recipe chosen("directions:6x3/single_layer/hbao");
    const auto composed = std::make_unique<crease::composition>(chosen);
    crease::parameters how = oracle::view_parameters(p, composed->view(), 0.5);
    how.strength = 0.7f;
    how.exponent = 2.5f;
    const oracle::settings s = oracle::settings_of(how);
    const auto expected = oracle::main_pass(p, s, 1, false, [&](const oracle::receiver& r) {
        return oracle::hbao(p, r, s, oracle::directions(p, r, s, 6, 3));
    });
    CHECK(oracle::compare(oracle::run(p, composed->view(), how), expected.visibility).mean < 0.6 * one_step);
}
