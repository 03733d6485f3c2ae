// SPDX-License-Identifier: MIT
// Whole images of the shaders against the oracle's.
//
// Where the coordinates of a tap lie on a texel's edge, single and double precision pick different texels;
// that moves a few pixels by one tap's share, so only the worst pixel may be as far off as that.
#include "run.hpp"
#include "techniques.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>

namespace {

using oracle::check_within;
using oracle::lens;
using oracle::technique;
using oracle::techniques;

/// Runs a technique with further parts on both sides, and compares.
oracle::difference
differ(const technique& t, const std::string& parts, lens kind, bool reconstructed,
       const std::function<oracle::visibility_image(const oracle::visibility_image&, const oracle::picture&,
                                                    const oracle::settings&)>& filter = {},
       int divisor = 1) {
    const oracle::picture p = oracle::draw(oracle::still_life(), kind, 97, 61);
    const std::string text = t.recipe() + parts + (kind == lens::orthographic ? "/orthographic" : "") +
                             (reconstructed ? "/reconstructed_normals" : "");
    const auto composed = oracle::compose(text);
    const crease::parameters how = oracle::view_parameters(p, composed->view(), 0.5);
    const oracle::settings s = oracle::settings_of(how, *composed);
    oracle::visibility_image expected = oracle::main_pass(
        p, s, divisor, reconstructed, [&](const oracle::receiver& r) { return t.occlusion(p, r, s); });
    if (filter)
        expected = filter(expected, p, s);
    return oracle::compare(oracle::run(p, composed->view(), how), expected);
}

// 8 bits hold no visibility but 0 and 1 without an error.
constexpr oracle::difference occluded_everywhere{
    .typical = 0.004, .mean = 0.0015, .border = 0.0015, .most = 0.3, .bias = 0.0006};
constexpr oracle::difference mostly_open{
    .typical = 0.004, .mean = 0.0001, .border = 0.0003, .most = 0.3, .bias = 0.00003};
constexpr oracle::difference filtered{
    .typical = 0.008, .mean = 0.0012, .border = 0.0012, .most = 0.016, .bias = 0.0005};

}

TEST_CASE("every estimator and sampler, in every projection") {
    for (const technique& t : techniques())
        for (lens kind :
             {lens::standard, lens::reversed, lens::infinite, lens::off_centre, lens::orthographic}) {
            CAPTURE(t.recipe());
            CAPTURE(static_cast<int>(kind));
            check_within(differ(t, "", kind, false), oracle::of_rounding);
        }
}

TEST_CASE("reconstructed normals, linear and linearised depth, and the fragment stage") {
    for (const technique& t : techniques()) {
        CAPTURE(t.recipe());
        check_within(differ(t, "", lens::standard, true), oracle::of_rounding);
        check_within(differ(t, "/linear_depth", lens::standard, false), oracle::of_rounding);
        check_within(differ(t, "/fragment", lens::standard, false), oracle::of_rounding);
        check_within(differ(t, "/fragment/linear_depth", lens::orthographic, true), oracle::of_rounding);
        check_within(differ(t, "/linearised_depth", lens::reversed, false), oracle::of_rounding);
        check_within(differ(t, "/fragment/linearised_depth", lens::orthographic, true), oracle::of_rounding);
    }
}

TEST_CASE("the bilateral filter") {
    for (int radius : {1, 4}) {
        CAPTURE(radius);
        const auto blur = [radius](const auto& image, const auto&, const auto& s) {
            return oracle::bilateral(image, s, radius);
        };
        check_within(
            differ(techniques()[1], "/bilateral:" + std::to_string(radius), lens::standard, false, blur),
            filtered);
    }
}

TEST_CASE("filters by planes, over 3 x 3, 5 x 5 and 7 x 7 pixels, in one pass and in two") {
    for (int radius : {1, 2, 3})
        for (lens kind : {lens::standard, lens::orthographic})
            for (bool reconstructed : {false, true}) {
                CAPTURE(radius);
                CAPTURE(static_cast<int>(kind));
                CAPTURE(reconstructed);
                const std::string number = ":" + std::to_string(radius);
                check_within(differ(techniques()[1], "/plane_filter" + number, kind, reconstructed,
                                    [radius](const auto& image, const auto& p, const auto& s) {
                                        return oracle::plane_filter(image, p, s, radius);
                                    }),
                             filtered);
                check_within(differ(techniques()[1], "/separable_plane_filter" + number, kind, reconstructed,
                                    [radius](const auto& image, const auto& p, const auto& s) {
                                        return oracle::separable_plane_filter(image, p, s, radius);
                                    }),
                             filtered);
            }
}

TEST_CASE("a filter by planes at half and quarter resolution, and one more at the whole") {
    for (int factor : {2, 4}) {
        CAPTURE(factor);
        const std::string number = ":" + std::to_string(factor);
        check_within(differ(
                         techniques()[1], "/plane_filter/upsample" + number, lens::standard, false,
                         [factor](const auto& image, const auto& p, const auto& s) {
                             return oracle::upsample(oracle::plane_filter(image, p, s, 2, factor), p, s,
                                                     factor);
                         },
                         factor),
                     filtered);
        check_within(
            differ(
                techniques()[1], "/upsample" + number + "/separable_plane_filter:2", lens::off_centre, false,
                [factor](const auto& image, const auto& p, const auto& s) {
                    return oracle::separable_plane_filter(oracle::upsample(image, p, s, factor), p, s, 2);
                },
                factor),
            filtered);
    }
}

TEST_CASE("upsampling from half, third and quarter resolution") {
    for (int factor : {2, 3, 4}) {
        CAPTURE(factor);
        const auto enlarge = [factor](const auto& image, const auto& p, const auto& s) {
            return oracle::upsample(image, p, s, factor);
        };
        check_within(differ(techniques()[1], "/upsample:" + std::to_string(factor), lens::standard, false,
                            enlarge, factor),
                     filtered);
    }
}

TEST_CASE("what shows between the pixels of the smaller picture is background") {
    // A floor by a wall, and a column of the picture in which there is nothing.
    using kind = oracle::surface::kind;
    oracle::picture p =
        oracle::draw({{kind::plane, {0, -0.5, 0}, {0, 1, 0}}, {kind::plane, {0, 0, -3}, {0, 0, 1}}},
                     lens::standard, 64, 48);
    for (int y = 0; y < p.height; ++y)
        p.device[p.index(33, y)] = static_cast<float>(p.clear_value());
    const std::vector<float> image = oracle::run(p, "directions:4x4/single_layer/hbao/upsample:2", 1);
    CHECK(*std::min_element(image.begin(), image.end()) < 0.9f);
    for (int y = 0; y < p.height; ++y)
        CHECK(image[p.index(33, y)] == 1.0f);
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
    struct coarse_filters {
        std::string filters;
        double most; ///< RMSE
    };
    for (const coarse_filters& of :
         {coarse_filters{"/bilateral:1/upsample:2", 0.0105}, {"/bilateral:1/upsample:4", 0.018}}) {
        const std::vector<float> coarse =
            oracle::run(p, "directions:8x8/single_layer/hbao" + of.filters, 0.8);
        double squares = 0, least = 1;
        for (std::size_t i = 0; i < whole.size(); ++i) {
            squares += (whole[i] - coarse[i]) * double{whole[i] - coarse[i]};
            least = std::min(least, double{whole[i]});
        }
        CAPTURE(of.filters);
        CHECK(least < 0.6);
        CHECK(std::sqrt(squares / static_cast<double>(whole.size())) < of.most);
    }
}

TEST_CASE("strength and exponent") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 64, 48);
    const auto composed = oracle::compose("directions:6x3/single_layer/hbao");
    crease::parameters how = oracle::view_parameters(p, composed->view(), 0.5);
    oracle::set(how, *composed, "strength", 0.7);
    oracle::set(how, *composed, "exponent", 2.5);
    const oracle::settings s = oracle::settings_of(how, *composed);
    const auto expected = oracle::main_pass(p, s, 1, false, [&](const oracle::receiver& r) {
        return oracle::hbao(p, r, s, oracle::directions(p, r, s, 6, 3));
    });
    check_within(oracle::compare(oracle::run(p, composed->view(), how), expected), oracle::of_rounding);
}

TEST_CASE("the horizon of HBAO begins no higher than a right angle, however large the bias") {
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 97, 61);
    const auto composed = oracle::compose("directions:6x8/single_layer/hbao");
    crease::parameters how = oracle::view_parameters(p, composed->view(), 0.5);
    oracle::set(how, *composed, "bias", 1.2);
    const oracle::settings s = oracle::settings_of(how, *composed);
    const auto expected = oracle::main_pass(p, s, 1, false, [&](const oracle::receiver& r) {
        return oracle::hbao(p, r, s, oracle::directions(p, r, s, 6, 8));
    });
    check_within(oracle::compare(oracle::run(p, composed->view(), how), expected), oracle::of_rounding);
}

TEST_CASE("a radius of a few texels") {
    // Taps fall on the receiver's own texel, and say nothing there.
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 97, 61);
    for (const technique& t : techniques()) {
        CAPTURE(t.recipe());
        const auto composed = oracle::compose(t.recipe());
        const crease::parameters how = oracle::view_parameters(p, composed->view(), 0.1);
        const oracle::settings s = oracle::settings_of(how, *composed);
        const auto expected = oracle::main_pass(
            p, s, 1, false, [&](const oracle::receiver& r) { return t.occlusion(p, r, s); });
        check_within(oracle::compare(oracle::run(p, composed->view(), how), expected), mostly_open);
    }
}

TEST_CASE("a radius that reaches behind the eye") {
    // Points there are no points of the picture, and a disk that is wider than the picture has few texels in
    // it.
    const oracle::picture p = oracle::draw(oracle::still_life(), lens::standard, 64, 48);
    for (const technique& t : techniques()) {
        CAPTURE(t.recipe());
        const auto composed = oracle::compose(t.recipe());
        const crease::parameters how = oracle::view_parameters(p, composed->view(), 6);
        const oracle::settings s = oracle::settings_of(how, *composed);
        const auto expected = oracle::main_pass(
            p, s, 1, false, [&](const oracle::receiver& r) { return t.occlusion(p, r, s); });
        check_within(oracle::compare(oracle::run(p, composed->view(), how), expected), occluded_everywhere);
    }
}

TEST_CASE("what stands just before the far plane does not darken the background behind it") {
    const double far_plane = 50;
    for (lens kind : {lens::standard, lens::reversed, lens::orthographic}) {
        CAPTURE(static_cast<int>(kind));
        const oracle::picture p = oracle::draw(
            {{oracle::surface::kind::half_plane, {0, 0, -(far_plane - 1)}, {0, 0, 1}}}, kind, 64, 48);
        for (const technique& t : techniques())
            for (const char* encoding : {"", "/linearised_depth"}) {
                CAPTURE(t.recipe());
                const std::vector<float> image = oracle::run(
                    p, t.recipe() + encoding + (kind == lens::orthographic ? "/orthographic" : ""), 10);
                for (int y = 0; y < p.height; ++y)
                    for (int x = 0; x < p.width; ++x)
                        if (p.background(x, y))
                            REQUIRE(image[p.index(x, y)] == 1);
            }
    }
}
