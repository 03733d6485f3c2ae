// SPDX-License-Identifier: MIT
// What an image of normals may hold: any length, texels without a direction, and what hosts have.
#include "run.hpp"
#include "techniques.hpp"

#include <doctest/doctest.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

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

namespace {

/// Normals with two or three components a texel, as hosts store them: by the texts of graphics pages, not by
/// what the shader does.
std::vector<float> stored(const std::vector<glm::vec3>& normals, bool packed, bool octahedral) {
    std::vector<float> texels;
    for (const glm::vec3& n : normals) {
        if (octahedral) { // Cigolle et al. 2014, listing 1
            const float sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
            glm::vec2 p(n.x / sum, n.y / sum);
            if (n.z < 0)
                p = {(1 - std::abs(n.y / sum)) * (n.x >= 0 ? 1.0f : -1.0f),
                     (1 - std::abs(n.x / sum)) * (n.y >= 0 ? 1.0f : -1.0f)};
            texels.insert(texels.end(), {p.x / 2 + 0.5f, p.y / 2 + 0.5f});
        } else if (packed) {
            texels.insert(texels.end(), {n.x / 2 + 0.5f, n.y / 2 + 0.5f, n.z / 2 + 0.5f, 1.0f});
        } else {
            texels.insert(texels.end(), {n.x, n.y, n.z, 0.0f});
        }
    }
    return texels;
}

}

TEST_CASE("normals as hosts have them give what those of view space give") {
    const oracle::picture p = oracle::draw(oracle::still_life(), oracle::lens::standard, 97, 61);
    const glm::mat3 to_view =
        glm::mat3(glm::rotate(glm::mat4(1), 2.1f, glm::normalize(glm::vec3(1, -2, 0.5f))));
    std::vector<glm::vec3> of_world;
    for (const glm::vec3& n : p.normals)
        of_world.push_back(glm::transpose(to_view) * n);
    struct kind {
        const char* name;
        bool packed, octahedral, world;
    };
    for (const kind& each :
         {kind{"packed_normals", true, false, false}, kind{"octahedral_normals", true, true, false},
          kind{"world_normals", false, false, true}, kind{"packed_world_normals", true, false, true},
          kind{"octahedral_world_normals", true, true, true}}) {
        const bool in_bytes = each.packed && !each.octahedral;
        oracle::picture seen = p;
        for (std::size_t i = 0; in_bytes && i < seen.normals.size(); ++i) {
            const glm::vec3 bytes =
                glm::round(((each.world ? of_world : p.normals)[i] * 0.5f + 0.5f) * 255.0f);
            const glm::vec3 rounded = bytes / 255.0f * 2.0f - 1.0f;
            seen.normals[i] = glm::normalize(each.world ? to_view * rounded : rounded);
        }
        for (std::size_t i = 0; i < techniques().size(); i += 3) { // as the estimator makes no difference
            const oracle::technique& t = techniques()[i];
            CAPTURE(std::string(each.name));
            CAPTURE(t.recipe());
            const auto composed = oracle::compose(t.recipe() + "/" + each.name);
            const crease::effect_view effect = *composed;
            crease::parameters how = oracle::view_parameters(p, effect, 0.5);
            if (each.world) {
                const glm::mat4 matrix(to_view);
                REQUIRE(crease::set_world_to_view(how, effect.settings, glm::value_ptr(matrix)));
            }
            crease::vulkan::runner runner(oracle::device(), effect, static_cast<unsigned>(p.width),
                                          static_cast<unsigned>(p.height));
            runner.upload("depth", p.device);
            runner.upload("normal", stored(each.world ? of_world : p.normals, each.packed, each.octahedral));
            runner.run(how);
            // Both sides take the same bytes: halves are rounded away from 0 by either.
            oracle::check_within(oracle::compare(runner.download("visibility"),
                                                 expect(seen, t, oracle::settings_of(how, effect))),
                                 oracle::of_rounding);
        }
    }
}

TEST_CASE("what stands just before the far plane leaves the background of logarithmic depth open") {
    const double far_plane = 50;
    const oracle::picture p =
        oracle::draw({{oracle::surface::kind::half_plane, {0, 0, -(far_plane - 1)}, {0, 0, 1}}},
                     oracle::lens::standard, 64, 48);
    std::vector<float> depth;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            depth.push_back(
                p.background(x, y) ? 1 : static_cast<float>(std::log2(far_plane) / std::log2(1 + far_plane)));
    const auto composed = oracle::compose("directions:8x4/single_layer/hbao_plus/logarithmic_depth");
    crease::parameters how = oracle::view_parameters(p, *composed, 10);
    oracle::set(how, *composed, "logarithmic_depth.far", far_plane);
    crease::vulkan::runner runner(oracle::device(), *composed, static_cast<unsigned>(p.width),
                                  static_cast<unsigned>(p.height));
    oracle::upload(runner, *composed, p);
    runner.upload("depth", depth);
    runner.run(how);
    const std::vector<float> found = runner.download("visibility");
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            if (p.background(x, y))
                REQUIRE(found[p.index(x, y)] == 1);
}

TEST_CASE("logarithmic depth gives what device depth gives") {
    const oracle::picture p = oracle::draw(oracle::still_life(), oracle::lens::standard, 97, 61);
    for (const double far_plane : {60.0, 1e5}) {
        std::vector<float> depth;
        for (int y = 0; y < p.height; ++y)
            for (int x = 0; x < p.width; ++x) {
                const double w = p.background(x, y) ? far_plane : -p.position(x, y).z;
                depth.push_back(static_cast<float>(std::log2(1 + w) / std::log2(1 + far_plane)));
            }
        for (const oracle::technique& t : techniques()) {
            CAPTURE(t.recipe());
            const auto composed = oracle::compose(t.recipe() + "/logarithmic_depth");
            crease::parameters how = oracle::view_parameters(p, *composed, 0.5);
            oracle::set(how, *composed, "logarithmic_depth.far", far_plane);
            crease::vulkan::runner runner(oracle::device(), *composed, static_cast<unsigned>(p.width),
                                          static_cast<unsigned>(p.height));
            oracle::upload(runner, *composed, p);
            runner.upload("depth", depth);
            runner.run(how);
            oracle::check_within(oracle::compare(runner.download("visibility"),
                                                 expect(p, t, oracle::settings_of(how, *composed))),
                                 oracle::of_rounding);
        }
    }
}
