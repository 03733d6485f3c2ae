// SPDX-License-Identifier: MIT
// reach: a front surface that is nearer to the receiver than so many radii settles its tap, and nothing
// behind it is looked at.
#include "captured.hpp"

#include <doctest/doctest.h>

#include <memory>

namespace {

using taps = std::vector<std::vector<oracle::tap>>;

// More of the picture than elsewhere is not 1, which 8 bits hold without an error.
constexpr oracle::difference mostly_occluded{
    .typical = 0.004, .mean = 0.0012, .border = 0.0012, .most = 0.3, .bias = 0.0003};

/// The occlusion by an estimator that finds nothing behind the near fronts among the taps.
template <class Estimator>
double settled(oracle::picture& p, const oracle::receiver& r, const taps& all, double reach,
               const Estimator& estimator) {
    std::vector<std::pair<std::size_t, std::vector<float>>> taken;
    for (const std::vector<oracle::tap>& direction : all)
        for (const oracle::tap& t : direction)
            if (glm::length(p.position(t.x, t.y) - r.position) < reach) {
                const std::size_t i = p.index(t.x, t.y);
                taken.emplace_back(i, std::move(p.hidden[i]));
                p.hidden[i].clear();
            }
    const double occlusion = estimator();
    while (!taken.empty()) { // the last first, as a texel may be tapped twice
        p.hidden[taken.back().first] = std::move(taken.back().second);
        taken.pop_back();
    }
    return occlusion;
}

/// The visibility by the oracle, of an estimator by its name in recipes.
oracle::visibility_image expect(oracle::picture& p, const oracle::settings& s, double reach, bool horizons) {
    return oracle::main_pass(p, s, 1, false, [&](const oracle::receiver& r) {
        const taps all = oracle::directions(p, r, s, 6, 4, 1);
        return settled(p, r, all, reach * s.radius, [&] {
            return horizons ? oracle::hbao(p, r, s, all) : oracle::hbao_plus(p, r, s, all);
        });
    });
}

}

TEST_CASE("within its reach the front surface settles its tap") {
    oracle::picture p = oracle::many_layers(oracle::lens::standard, 97, 61, 6);
    for (const bool horizons : {true, false})
        // Deferred layers of HBAO count from the horizon of all fronts of their direction, which is tested
        // apart.
        for (const std::string traversal : {"front_first:0", "deferred_layers:0x4"}) {
            if (horizons && traversal == "deferred_layers:0x4")
                continue;
            const auto composed = oracle::compose("directions:6x4x1/stochastic_layers:6/" +
                                                  std::string(horizons ? "hbao" : "hbao_plus") +
                                                  "/atomic_minimum/" + traversal);
            const given_layers given(*composed);
            crease::vulkan::runner runner(oracle::device(), given, static_cast<unsigned>(p.width),
                                          static_cast<unsigned>(p.height));
            oracle::upload(runner, given, p);
            runner.upload("captured_layers", oracle::share_out(p, 6));
            std::vector<float> without;
            for (float reach : {0.0f, 0.3f, 0.7f, 1.0f}) {
                CAPTURE(horizons);
                CAPTURE(traversal);
                CAPTURE(reach);
                crease::parameters how = oracle::view_parameters(p, *composed, 2);
                oracle::set(how, *composed, "reach", reach);
                runner.run(how);
                const std::vector<float> image = runner.download("visibility");
                oracle::check_within(oracle::compare(image, expect(p, oracle::settings_of(how, *composed),
                                                                   double{reach}, horizons)),
                                     mostly_occluded);
                std::size_t other = 0;
                for (std::size_t i = 0; i < without.size(); ++i)
                    other += image[i] != without[i];
                if (reach == 0)
                    without = image;
                else if (reach >= 0.7f)
                    CHECK(other > 20);
            }
        }
}
