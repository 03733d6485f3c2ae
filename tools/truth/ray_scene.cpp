// SPDX-License-Identifier: MIT
#include "truth/ray_scene.hpp"

#include "truth/truth.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>

namespace crease::tools {
namespace {

RTCRayHit make_ray(const glm::vec3& origin, const glm::vec3& direction, float nearest, float farthest) {
    RTCRayHit ray{};
    ray.ray.org_x = origin.x;
    ray.ray.org_y = origin.y;
    ray.ray.org_z = origin.z;
    ray.ray.tnear = nearest;
    ray.ray.dir_x = direction.x;
    ray.ray.dir_y = direction.y;
    ray.ray.dir_z = direction.z;
    ray.ray.tfar = farthest;
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    return ray;
}

/// What a ray carries along: where it goes through transparent triangles.
struct passing_context {
    RTCIntersectContext embree;
    std::vector<ray_scene::crossing>* passed;
};

/// Lets a ray through a transparent triangle, and notes where.
void pass(const RTCFilterFunctionNArguments* at) {
    const unsigned triangle = RTCHitN_primID(at->hit, at->N, 0);
    const float opacity = static_cast<const eye_mesh*>(at->geometryUserPtr)->material_of(triangle).colour.a;
    if (opacity == 1)
        return;
    at->valid[0] = 0;
    reinterpret_cast<passing_context*>(at->context)
        ->passed->push_back({RTCRayN_tfar(at->ray, at->N, 0), opacity, triangle, RTCHitN_u(at->hit, at->N, 0),
                             RTCHitN_v(at->hit, at->N, 0)});
}

float largest_coordinate(const glm::dvec3& p) {
    return static_cast<float>(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
}

}

ray_scene::ray_scene(eye_mesh source) : source_(std::move(source)), device_(rtcNewDevice(nullptr)) {
    if (!device_)
        throw truth_error("Embree finds no device to trace on");
    scene_.reset(rtcNewScene(device_.get()));
    // Without it a ray may slip through the edge between two triangles.
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    const std::unique_ptr<RTCGeometryTy, decltype(&rtcReleaseGeometry)> geometry(
        rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE), &rtcReleaseGeometry);
    void* positions = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                              sizeof(glm::vec3), source_.positions.size());
    void* indices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            3 * sizeof(std::uint32_t), source_.triangles());
    if (!positions || !indices)
        throw truth_error("not enough memory to trace this scene");
    std::memcpy(positions, source_.positions.data(), source_.positions.size() * sizeof(glm::vec3));
    std::memcpy(indices, source_.indices.data(), source_.indices.size() * sizeof(std::uint32_t));
    if (std::ranges::any_of(source_.material_ids,
                            [&](std::uint32_t id) { return source_.materials[id].colour.a < 1; })) {
        rtcSetGeometryUserData(geometry.get(), &source_);
        rtcSetGeometryIntersectFilterFunction(geometry.get(), &pass);
    }
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(scene_.get(), geometry.get());
    rtcCommitScene(scene_.get());
    if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE)
        throw truth_error("not enough memory to trace this scene");
}

void ray_scene::trace(const glm::vec3& origin, const glm::vec3& direction, float nearest, float farthest,
                      std::vector<crossing>& found) const {
    found.clear();
    passing_context context{.embree = {}, .passed = &found};
    rtcInitIntersectContext(&context.embree);
    RTCRayHit ray = make_ray(origin, direction, nearest, farthest);
    rtcIntersect1(scene_.get(), &context.embree, &ray);
    std::erase_if(found, [&](const crossing& each) { return each.distance > ray.ray.tfar; });
    if (ray.hit.geomID != RTC_INVALID_GEOMETRY_ID)
        found.push_back({ray.ray.tfar, 1, ray.hit.primID, ray.hit.u, ray.hit.v});
    if (found.size() < 2)
        return;
    std::ranges::sort(found, [](const crossing& a, const crossing& b) {
        return std::tie(a.distance, a.triangle) < std::tie(b.distance, b.triangle);
    });
    const float most = largest_coordinate(origin) + found.back().distance;
    const auto repeated = [&](const crossing& a, const crossing& b) { return are_one_surface(a, b, most); };
    found.erase(std::unique(found.begin(), found.end(), repeated), found.end());
}

/// Whether a ray goes through the edge between two triangles, and meets both of them but one surface.
bool ray_scene::are_one_surface(const crossing& a, const crossing& b, float most) const {
    const float roundings = 16 * std::numeric_limits<float>::epsilon() * most;
    return a.opacity == b.opacity && b.distance - a.distance <= roundings &&
           shared_corners(a.triangle, b.triangle) == 2;
}

unsigned ray_scene::shared_corners(std::uint32_t a, std::uint32_t b) const {
    unsigned shared = 0;
    for (unsigned i = 0; i < 3; ++i)
        for (unsigned k = 0; k < 3; ++k)
            shared += corner(a, i) == corner(b, k);
    return shared;
}

ray_scene::surface ray_scene::surface_at(const crossing& at, const glm::vec3& direction) const {
    std::array<glm::dvec3, 3> corners;
    for (unsigned i = 0; i < 3; ++i)
        corners[i] = corner(at.triangle, i);
    const glm::dvec3 edge_u = corners[1] - corners[0], edge_v = corners[2] - corners[0];
    // From the barycentric coordinates, as origin + t * direction misses the plane by the error of t.
    const glm::dvec3 position = corners[0] + double{at.u} * edge_u + double{at.v} * edge_v;
    glm::dvec3 normal = normal_of(corners[0], corners[1], corners[2]);
    if (glm::dot(normal, glm::dvec3(direction)) > 0)
        normal = -normal;
    // The ray's own plane is missed by some roundings of the position, and of the corners as seen from it.
    constexpr float roundings = 16 * std::numeric_limits<float>::epsilon();
    float magnitude = largest_coordinate(position);
    for (const glm::dvec3& c : corners)
        magnitude = std::max(magnitude, largest_coordinate(c - position));
    return {position, normal, roundings * magnitude};
}

}
