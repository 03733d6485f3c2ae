// SPDX-License-Identifier: MIT
// What an image of normals may hold: any length, and texels without a direction.
#include "run.hpp"
#include "techniques.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace {

const std::vector<oracle::technique>& techniques() {
    return oracle::techniques();
}

/// The visibility where the image of normals holds these, three numbers a texel.
std::vector<float> run_with(const oracle::picture& p, const crease::effect_view& effect,
                            const crease::parameters& how, const std::vector<glm::vec3>& normals) {
    crease::vulkan::runner runner(oracle::device(), effect, static_cast<unsigned>(p.width),
                                  static_cast<unsigned>(p.height));
    oracle::upload(runner, effect, p);
    std::vector<float> texels;
    for (const glm::vec3& n : normals)
        texels.insert(texels.end(), {n.x, n.y, n.z, 0.0f});
    runner.upload("normal", texels);
    runner.run(how);
    return runner.download("visibility");
}

oracle::visibility_image expect(const oracle::picture& p, const oracle::technique& t,
                                const oracle::settings& s) {
    return oracle::main_pass(p, s, 1, false, [&](const oracle::receiver& r) { return t.occlusion(p, r, s); });
}

}

TEST_CASE("normals of any length are normalised") {
    const oracle::picture p = oracle::draw(oracle::still_life(), oracle::lens::standard, 97, 61);
    std::vector<glm::vec3> normals = p.normals;
    for (std::size_t i = 0; i < normals.size(); ++i)
        normals[i] *=
            std::exp2(static_cast<float>(i % 13) - 6); // by powers of 2, so that halves stay what they are
    for (const oracle::technique& t : techniques()) {
        CAPTURE(t.recipe());
        const auto composed = oracle::compose(t.recipe());
        const crease::parameters how = oracle::view_parameters(p, *composed, 0.5);
        oracle::check_within(oracle::compare(run_with(p, *composed, how, normals),
                                             expect(p, t, oracle::settings_of(how, *composed))),
                             oracle::of_rounding);
    }
}

TEST_CASE("normals that are zero or not finite count as facing the eye") {
    const oracle::picture whole = oracle::draw(oracle::still_life(), oracle::lens::standard, 97, 61);
    const float infinity = std::numeric_limits<float>::infinity(), nan = std::nanf("");
    const glm::vec3 broken[] = {
        {0, 0, 0}, {nan, nan, nan}, {0.6f, nan, 0.8f}, {infinity, 0, 0}, {0, -infinity, infinity}};
    oracle::picture p = whole; // as the oracle sees it
    std::vector<glm::vec3> normals = p.normals;
    for (int y = 0; y < p.height; ++y)
        for (int x = y % 3; x < p.width; x += 3) {
            const std::size_t i = p.index(x, y);
            normals[i] = broken[i % 5];
            p.normals[i] = p.background(x, y) ? glm::vec3(0, 0, 1) : glm::vec3(p.to_eye(p.position(x, y)));
        }
    for (const oracle::technique& t : techniques()) {
        CAPTURE(t.recipe());
        const auto composed = oracle::compose(t.recipe());
        const crease::parameters how = oracle::view_parameters(p, *composed, 0.5);
        const std::vector<float> image = run_with(p, *composed, how, normals);
        for (float v : image)
            REQUIRE(std::isfinite(v));
        oracle::check_within(oracle::compare(image, expect(p, t, oracle::settings_of(how, *composed))),
                             oracle::of_rounding);
    }
}
