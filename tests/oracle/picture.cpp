// SPDX-License-Identifier: MIT
#include "picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oracle {

glm::dvec3 picture::unproject(glm::dvec2 texel, double z) const {
    const glm::dvec4 clip(2 * texel.x / width - 1, 2 * texel.y / height - 1, z, 1);
    const glm::dvec4 view = glm::inverse(projection) * clip;
    return glm::dvec3(view) / view.w;
}

glm::dvec2 picture::project(glm::dvec3 position) const {
    const glm::dvec4 clip = projection * glm::dvec4(position, 1);
    return {(clip.x / clip.w + 1) / 2 * width, (clip.y / clip.w + 1) / 2 * height};
}

std::vector<glm::dvec3> picture::positions(int x, int y) const {
    std::vector<glm::dvec3> all{position(x, y)};
    if (!hidden.empty())
        for (float z : hidden[index(x, y)])
            all.push_back(unproject({x + 0.5, y + 0.5}, z));
    return all;
}

void picture::ray(glm::dvec2 texel, glm::dvec3& origin, glm::dvec3& direction) const {
    const glm::dvec3 near_point = unproject(texel, reversed ? 1 : 0), middle = unproject(texel, 0.5);
    direction = glm::normalize(middle - near_point);
    origin = near_point;
}

glm::dvec3 picture::to_eye(glm::dvec3 position) const {
    return is_perspective() ? -glm::normalize(position) : glm::dvec3(0, 0, 1);
}

glm::dmat4 make_projection(lens kind, double aspect) {
    const double near_plane = 0.1, far_plane = 50, scale = 1 / std::tan(glm::radians(30.0));
    glm::dmat4 m(0);
    m[0][0] = scale / aspect;
    m[1][1] = -scale; // Vulkan's clip space points down
    m[2][3] = -1;
    m[2][2] = -far_plane / (far_plane - near_plane);
    m[3][2] = -far_plane * near_plane / (far_plane - near_plane);
    if (kind == lens::reversed) {
        m[2][2] = near_plane / (far_plane - near_plane);
        m[3][2] = far_plane * near_plane / (far_plane - near_plane);
    } else if (kind == lens::infinite) {
        m[2][2] = 0;
        m[3][2] = near_plane;
    } else if (kind == lens::off_centre) {
        m[2][0] = 0.3;
        m[2][1] = -0.2;
    } else if (kind == lens::orthographic || kind == lens::anamorphic) {
        m = glm::dmat4(0);
        m[0][0] = (kind == lens::anamorphic ? 0.48 : 0.5) / aspect;
        m[1][1] = -0.5;
        m[2][2] = -1 / (far_plane - near_plane);
        m[3][2] = -near_plane / (far_plane - near_plane);
        m[3][0] = 0.1;
        m[3][1] = 0.05;
        m[3][3] = 1;
    }
    return m;
}

namespace {

/// Distance along a unit ray to a surface, and its normal there; infinity where it is missed.
double meet(const surface& s, glm::dvec3 origin, glm::dvec3 direction, glm::dvec3& normal) {
    const double nothing = std::numeric_limits<double>::infinity();
    if (s.shape == surface::kind::plane || s.shape == surface::kind::half_plane) {
        const double t = glm::dot(s.point - origin, s.normal) / glm::dot(direction, s.normal);
        normal = s.normal;
        const bool beside = s.shape == surface::kind::half_plane && (origin + t * direction).x < s.point.x;
        return t > 0 && !beside ? t : nothing;
    }
    const glm::dvec3 to_centre = s.point - origin;
    const double along = glm::dot(to_centre, direction);
    const double half = s.radius * s.radius - (glm::dot(to_centre, to_centre) - along * along);
    if (half < 0)
        return nothing;
    const double t = s.shape == surface::kind::sphere ? along - std::sqrt(half) : along + std::sqrt(half);
    normal = (origin + t * direction - s.point) / s.radius;
    return t > 0 ? t : nothing;
}

}

bool first_hit(const std::vector<surface>& surfaces, glm::dvec3 origin, glm::dvec3 direction,
               glm::dvec3& position, glm::dvec3& normal) {
    double nearest = 200;
    glm::dvec3 candidate;
    for (const surface& s : surfaces)
        if (const double t = meet(s, origin, direction, candidate); t < nearest) {
            nearest = t;
            normal = candidate;
        }
    position = origin + nearest * direction;
    return nearest < 200;
}

picture draw(const std::vector<surface>& surfaces, lens kind, int width, int height) {
    picture p;
    p.width = width;
    p.height = height;
    p.projection = make_projection(kind, static_cast<double>(width) / height);
    p.reversed = kind == lens::reversed || kind == lens::infinite;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            glm::dvec3 origin, direction, position, normal(0, 0, 1);
            p.ray({x + 0.5, y + 0.5}, origin, direction);
            const bool met = first_hit(surfaces, origin, direction, position, normal);
            const glm::dvec4 clip = p.projection * glm::dvec4(position, 1);
            const double z = clip.z / clip.w;
            const bool seen = met && -position.z < 49.5;
            p.device.push_back(static_cast<float>(seen ? z : p.clear_value()));
            p.normals.push_back(glm::vec3(glm::dot(normal, p.to_eye(position)) < 0 ? -normal : normal));
        }
    return p;
}

picture draw_all(const std::vector<surface>& surfaces, lens kind, int width, int height) {
    picture p = draw(surfaces, kind, width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            glm::dvec3 origin, direction, normal;
            p.ray({x + 0.5, y + 0.5}, origin, direction);
            std::vector<float> depths;
            for (const surface& s : surfaces) {
                const glm::dvec3 position = origin + meet(s, origin, direction, normal) * direction;
                const glm::dvec4 clip = p.projection * glm::dvec4(position, 1);
                if (-position.z < 49.5)
                    depths.push_back(static_cast<float>(clip.z / clip.w));
            }
            std::ranges::sort(depths);
            if (p.reversed)
                std::ranges::reverse(depths);
            p.hidden.emplace_back(depths.begin() + (depths.empty() ? 0 : 1), depths.end());
        }
    return p;
}

std::vector<surface> still_life() {
    using kind = surface::kind;
    return {{kind::plane, {0, -1, 0}, {0, 1, 0}},
            {kind::plane, {-1.5, 0, 0}, {1, 0, 0}},
            {kind::plane, {0, 0, -6}, glm::normalize(glm::dvec3(0.3, -0.9, 0.4))},
            {kind::sphere, {0.2, -0.6, -3}, {}, 0.4},
            {kind::sphere, {-0.5, -0.75, -2.4}, {}, 0.25}};
}

}
