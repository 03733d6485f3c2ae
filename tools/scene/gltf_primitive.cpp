// SPDX-License-Identifier: MIT
#include "scene/gltf_primitive.hpp"

#include "scene/scene.hpp"

#include <fmt/format.h>

namespace crease::tools {
namespace {

enum mode : std::size_t { triangles = 4, strip, fan };

constexpr const char* draco = "KHR_draco_mesh_compression";

/// Reads an accessor of so many columns, and rows where they are known.
const gltf_accessor& read(const gltf_value& reference, gltf_accessors& accessors, std::size_t columns,
                          const gltf_accessor* rows_of = nullptr) {
    const gltf_accessor& found = accessors.read(reference);
    if (found.columns() != columns)
        reference.fail(fmt::format("must have {} numbers a row, and has {}", columns, found.columns()));
    if (rows_of && found.rows() != rows_of->rows())
        reference.fail(fmt::format("has {} rows, and there are {} positions", found.rows(), rows_of->rows()));
    return found;
}

void require_data(const gltf_value& of, const gltf_accessor& accessor, const char* what) {
    if (accessor.has_data())
        return;
    if (of.has("extensions") && of["extensions"].has(draco))
        throw scene_error(fmt::format("is compressed with {}, which is not read; export it without", draco));
    of.fail(fmt::format("has {} without data", what));
}

std::size_t triangles_of(std::size_t mode, std::size_t corners) {
    if (mode == triangles)
        return corners / 3;
    return mode > triangles && corners > 2 ? corners - 2 : 0;
}

}

gltf_primitive read_gltf_primitive(const gltf_value& of, gltf_accessors& accessors) {
    gltf_primitive made{.source = of};
    const gltf_value attributes = of["attributes"];
    made.mode = of.has("mode") ? of["mode"].index(fan + 1) : triangles;
    if (made.mode < triangles || !attributes.has("POSITION"))
        return made;
    made.positions = &read(attributes["POSITION"], accessors, 3);
    require_data(of, *made.positions, "positions");
    if (of.has("indices")) {
        made.indices = &read(of["indices"], accessors, 1);
        require_data(of, *made.indices, "indices");
    }
    for (std::size_t i = 0; i < of.count("targets"); ++i) {
        const gltf_value target = of["targets"].at(i);
        made.targets.push_back(
            target.has("POSITION") ? &read(target["POSITION"], accessors, 3, made.positions) : nullptr);
    }
    for (std::size_t set = 0;; ++set) {
        const std::string joints = fmt::format("JOINTS_{}", set), weights = fmt::format("WEIGHTS_{}", set);
        if (!attributes.has(joints.c_str()))
            break;
        made.influences.push_back({&read(attributes[joints.c_str()], accessors, 4, made.positions),
                                   &read(attributes[weights.c_str()], accessors, 4, made.positions)});
    }
    made.triangles = triangles_of(made.mode, made.indices ? made.indices->rows() : made.positions->rows());
    return made;
}

std::array<std::size_t, 3> gltf_primitive::triangle(std::size_t i) const {
    std::array<std::size_t, 3> corners{3 * i, 3 * i + 1, 3 * i + 2};
    if (mode == strip)
        corners = {i, i + 1 + i % 2, i + 2 - i % 2};
    else if (mode == fan)
        corners = {0, i + 1, i + 2};
    for (std::size_t& corner : corners) {
        const double vertex = indices ? indices->at(corner, 0) : static_cast<double>(corner);
        if (!(vertex >= 0 && vertex < static_cast<double>(positions->rows())))
            source.fail(
                fmt::format("has a triangle of vertex {}, and {} vertices", vertex, positions->rows()));
        corner = static_cast<std::size_t>(vertex);
    }
    return corners;
}

}
