// SPDX-License-Identifier: MIT
#include "truth/truth.hpp"

#include "truth/ray_scene.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>

namespace crease::tools {
namespace {

void check(const truth_settings& settings) {
    if (settings.width == 0 || settings.height == 0 || settings.width > longest_side ||
        settings.height > longest_side)
        throw truth_error(fmt::format("the truth of {} x {} texels; both must be 1 to {}", settings.width,
                                      settings.height, longest_side));
    if (!(settings.radius >= 0) || std::isinf(settings.radius))
        throw truth_error(
            fmt::format("the truth for radius {}; it must be finite and not negative", settings.radius));
    if (settings.rays == 0)
        throw truth_error("the truth with 0 rays; use at least 1");
}

/// A good mixture of the bits (Wellons' lowbias32).
std::uint32_t mix(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

/// The points of a rank-1 lattice in the unit square, moved by a random offset of each texel: even as a grid,
/// yet free of a pattern that neighbours share. Whole numbers wrap around as the square's edges do.
class lattice {
public:
    lattice(unsigned points, std::uint32_t x, std::uint32_t y, std::uint32_t seed)
        : step_(0x1p32 / points), start_x_(mix(x ^ mix(y ^ mix(seed)))), start_y_(mix(start_x_)) {}

    glm::dvec2 operator()(unsigned i) const {
        constexpr std::uint32_t golden = 0x9e3779b9; // 2^32 / golden ratio
        const auto even = static_cast<std::uint32_t>(static_cast<std::uint64_t>(i * step_));
        return glm::dvec2(start_x_ + even, start_y_ + golden * i) * 0x1p-32;
    }

private:
    double step_;
    std::uint32_t start_x_, start_y_;
};

/// Columns: tangent, bitangent, normal.
glm::mat3 frame_around(const glm::vec3& normal) {
    const glm::vec3 away = std::abs(normal.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 tangent = glm::normalize(glm::cross(away, normal));
    return {tangent, glm::cross(normal, tangent), normal};
}

/// Density cos(theta) / pi around +Z.
glm::vec3 cosine_direction(const glm::dvec2& point) {
    const double radius = std::sqrt(point.x), angle = 2 * std::numbers::pi * point.y;
    return {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1 - point.x)};
}

/// Traces single texels into the images of a truth; texels may be traced at the same time.
class texel_tracer {
public:
    texel_tracer(eye_mesh scene, const camera& from, const truth_settings& settings, truth& result)
        : unit_(scene.scale.unit), radius_(scene.scale.radius(settings.radius)), scene_(std::move(scene)),
          camera_(from), settings_(settings), result_(result), view_(view_rotation(from)),
          window_(window_of(from, static_cast<double>(settings.width) / settings.height)) {}

    /// Depth, normal and, where it may occlude, what lies around.
    void trace(unsigned x, unsigned y, bool gathers) const {
        const glm::dvec2 through =
            window_.middle + window_.half * glm::dvec2(2 * (x + 0.5) / settings_.width - 1,
                                                       1 - 2 * (y + 0.5) / settings_.height);
        const glm::dmat3 world = glm::transpose(view_);
        // Left at length 1 along the view, so that the ray's parameter is the view depth.
        const glm::vec3 origin =
                            camera_.orthographic ? world * glm::dvec3(through / unit_, 0) : glm::dvec3(0),
                        direction =
                            world * (camera_.orthographic ? glm::dvec3(0, 0, -1) : glm::dvec3(through, -1));
        std::vector<ray_scene::crossing> seen;
        scene_.trace(origin, direction, depth_of(camera_.near), depth_of(camera_.far), seen);
        if (seen.empty())
            return;
        const ray_scene::surface first = scene_.surface_at(seen.front(), direction);
        result_.depth.at(x, y) = static_cast<float>(-(view_ * glm::dvec3(first.position)).z * unit_);
        const glm::vec3 normal = glm::normalize(view_ * glm::dvec3(first.normal));
        for (unsigned c = 0; c < 3; ++c)
            result_.normal.at(x, y, c) = normal[static_cast<int>(c)];
        if (gathers && radius_ > 0)
            receive(x, y, seen, direction);
    }

private:
    /// A depth of the world in the units of the scene, as far as 32 bits hold it.
    float depth_of(float in_world) const { return static_cast<float>(std::min(in_world / unit_, 0x1p100)); }

    /// What is around a receiver, as sums over its rays.
    struct gathered {
        double hard = 0, linear = 0, quad = 0; ///< occlusion
        double seen = 0;                       ///< linear, by what the camera sees
        glm::dvec3 open{0};                    ///< directions, each weighed by its visibility

        void add(double share, const gathered& other) {
            hard += share * other.hard;
            linear += share * other.linear;
            quad += share * other.quad;
            seen += share * other.seen;
            open += share * other.open;
        }
    };

    /// The receivers of a texel, merged.
    void receive(unsigned x, unsigned y, const std::vector<ray_scene::crossing>& receivers,
                 const glm::vec3& direction) const {
        gathered all;
        double through = 1;
        std::uint32_t seed = settings_.seed;
        for (const ray_scene::crossing& each : receivers) {
            const ray_scene::surface at = scene_.surface_at(each, direction);
            const lattice points(settings_.rays, x, y, seed);
            const double share = through * double{each.opacity};
            const bool is_hull = settings_.hull && each.opacity < 1;
            all.add(share * (is_hull ? double{each.opacity} : 1), gather(points, at, at.normal));
            if (is_hull)
                all.add(share * (1 - double{each.opacity}), gather(points, at, -at.normal));
            through *= 1 - double{each.opacity};
            seed = mix(seed + 1);
        }
        if (all.open != glm::dvec3(0))
            for (unsigned c = 0; c < 3; ++c)
                result_.bent.at(x, y, c) =
                    static_cast<float>((view_ * glm::normalize(all.open))[static_cast<int>(c)]);
        if (settings_.first_layer)
            result_.ao_first_layer.at(x, y) = static_cast<float>(1 - all.seen / settings_.rays);
        result_.ao_hard.at(x, y) = static_cast<float>(1 - all.hard / settings_.rays);
        result_.ao_linear.at(x, y) = static_cast<float>(1 - all.linear / settings_.rays);
        result_.ao_quad.at(x, y) = static_cast<float>(1 - all.quad / settings_.rays);
    }

    gathered gather(const lattice& points, const ray_scene::surface& at, const glm::vec3& normal) const {
        const glm::mat3 frame = frame_around(normal);
        const glm::vec3 origin = at.position + at.offset * normal;
        gathered sum;
        std::vector<ray_scene::crossing> met;
        for (unsigned i = 0; i < settings_.rays; ++i) {
            const glm::vec3 direction = frame * cosine_direction(points(i));
            scene_.trace(origin, direction, 0, radius_, met);
            double through = 1, visible = 0;
            for (const ray_scene::crossing& each : met) {
                const double d = each.distance / double{radius_}, share = through * double{each.opacity};
                if (d > 1)
                    break;
                sum.hard += share;
                sum.linear += share * (1 - d);
                sum.quad += share * (1 - d * d);
                if (settings_.first_layer && is_seen(origin + each.distance * direction))
                    sum.seen += share * (1 - d);
                visible += share * d;
                through *= 1 - double{each.opacity};
            }
            sum.open += glm::dvec3(direction) * (visible + through);
        }
        return sum;
    }

    /// Whether no surface hides a point from the camera; what lies outside the picture counts as seen.
    bool is_seen(const glm::vec3& point) const {
        const glm::dvec3 at = view_ * glm::dvec3(point);
        const glm::dvec2 place =
            window_.place_of(camera_.orthographic ? glm::dvec2(at) * unit_ : glm::dvec2(at) / -at.z);
        const double x = (place.x + 1) / 2 * settings_.width, y = (1 - place.y) / 2 * settings_.height;
        if (!(at.z < 0 && x >= 0 && y >= 0 && x < settings_.width && y < settings_.height))
            return true;
        // A surface that is hidden by less than this is only a neighbour's slope.
        const double slack = 0.1 * settings_.radius;
        return -at.z * unit_ <= result_.depth.at(static_cast<unsigned>(x), static_cast<unsigned>(y)) + slack;
    }

    double unit_;  ///< of the scene, world units
    float radius_; ///< in that unit
    ray_scene scene_;
    const camera& camera_;
    const truth_settings& settings_;
    truth& result_;
    glm::dmat3 view_;
    view_window window_;
};

/// Does every row once, on all threads; only the calling thread, which works too, reports.
/// @return false where the report asked to stop
template <typename Row>
bool for_each_row(const truth_settings& settings, Row row) {
    std::atomic<unsigned> next = 0, done = 0;
    std::atomic<bool> stop = false;
    const auto work = [&](auto report) {
        for (unsigned y; !stop && (y = next++) < settings.height;) {
            row(y);
            ++done;
            report();
        }
    };
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    const unsigned threads = std::min(settings.threads ? settings.threads : cores, settings.height);
    std::vector<std::jthread> others;
    struct stop_others {
        std::atomic<bool>& flag;
        ~stop_others() { flag = true; }
    } const stop_on_exception{stop};
    for (unsigned i = 1; i < threads; ++i)
        others.emplace_back(work, [] {});
    const auto report = [&] {
        if (settings.progress && !settings.progress(static_cast<double>(done) / settings.height))
            stop = true;
    };
    work(report);
    others.clear(); // joins
    if (!stop)
        report();
    return !stop;
}

}

truth trace_truth(const mesh& scene, const camera& from, const truth_settings& settings) {
    check(settings);
    check_mesh(scene, "the scene to trace");
    truth result;
    result.ao_hard = result.ao_linear = result.ao_quad = image(settings.width, settings.height, 1, 1);
    result.depth = image(settings.width, settings.height, 1, from.far);
    result.normal = result.bent = image(settings.width, settings.height, 3);
    if (settings.first_layer)
        result.ao_first_layer = result.ao_linear;
    const texel_tracer tracer(seen_from(from.eye, scene), from, settings, result);
    const auto all_texels = [&](bool gathers) {
        return for_each_row(settings, [&](unsigned y) {
            for (unsigned x = 0; x < settings.width; ++x)
                tracer.trace(x, y, gathers);
        });
    };
    // What hides what follows from the depths of all texels.
    if ((settings.first_layer && !all_texels(false)) || !all_texels(true))
        throw truth_cancelled("the truth was cancelled");
    return result;
}

image hidden_mask(const truth& traced) {
    image mask(traced.ao_linear.width, traced.ao_linear.height);
    for (std::size_t i = 0; i < mask.texels.size(); ++i)
        mask.texels[i] = traced.ao_first_layer.texels[i] - traced.ao_linear.texels[i] > 0.15f ? 1.0f : 0.0f;
    return mask;
}

}
