// SPDX-License-Identifier: MIT
#include "truth/ray_scene.hpp"

#include "truth/truth.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

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

void intersect(RTCScene scene, RTCRayHit& ray) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
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
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(scene_.get(), geometry.get());
    rtcCommitScene(scene_.get());
    if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE)
        throw truth_error("not enough memory to trace this scene");
}

std::optional<ray_scene::surface> ray_scene::first_hit(const glm::vec3& origin, const glm::vec3& direction,
                                                       float nearest, float farthest) const {
    RTCRayHit ray = make_ray(origin, direction, nearest, farthest);
    intersect(scene_.get(), ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return std::nullopt;
    std::array<glm::dvec3, 3> corner;
    for (unsigned i = 0; i < 3; ++i)
        corner[i] = source_.positions[source_.indices[3 * std::size_t{ray.hit.primID} + i]];
    const glm::dvec3 edge_u = corner[1] - corner[0], edge_v = corner[2] - corner[0];
    // From the barycentric coordinates, as origin + t * direction misses the plane by the error of t.
    const glm::dvec3 position = corner[0] + double{ray.hit.u} * edge_u + double{ray.hit.v} * edge_v;
    glm::dvec3 normal = normal_of(corner[0], corner[1], corner[2]);
    if (glm::dot(normal, glm::dvec3(direction)) > 0)
        normal = -normal;
    // The ray's own plane is missed by some roundings of the position, and of the corners as seen from it.
    constexpr float roundings = 16 * std::numeric_limits<float>::epsilon();
    float magnitude = largest_coordinate(position);
    for (const glm::dvec3& c : corner)
        magnitude = std::max(magnitude, largest_coordinate(c - position));
    return surface{position, normal, roundings * magnitude};
}

float ray_scene::distance(const glm::vec3& origin, const glm::vec3& direction, float farthest) const {
    RTCRayHit ray = make_ray(origin, direction, 0, farthest);
    intersect(scene_.get(), ray);
    return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<float>::infinity() : ray.ray.tfar;
}

}
