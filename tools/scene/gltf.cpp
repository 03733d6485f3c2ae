// SPDX-License-Identifier: MIT
#include "scene/gltf.hpp"

#include "scene/gltf_material.hpp"
#include "scene/gltf_nodes.hpp"
#include "scene/gltf_primitive.hpp"
#include "scene/limits.hpp"
#include "scene/shown.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace crease::tools {
namespace {

constexpr const char* instancing = "EXT_mesh_gpu_instancing";

/// Extensions that are read, or that leave triangles as they are. Those of materials begin with
/// KHR_materials_.
constexpr std::string_view readable_extensions[] = {instancing,
                                                    "EXT_lights_image_based",
                                                    "EXT_texture_avif",
                                                    "EXT_texture_webp",
                                                    "KHR_animation_pointer",
                                                    "KHR_lights_punctual",
                                                    "KHR_mesh_quantization",
                                                    "KHR_texture_basisu",
                                                    "KHR_texture_transform",
                                                    "KHR_xmp_json_ld",
                                                    "MSFT_texture_dds"};

void check_version(const gltf_value& root) {
    const gltf_value asset = root["asset"];
    const gltf_value least = asset[asset.has("minVersion") ? "minVersion" : "version"];
    const bool is_read = asset.has("minVersion") ? least.text() == "2.0" : least.text().starts_with("2.");
    if (!is_read)
        throw scene_error(
            fmt::format("is glTF of version {}; only version 2.0 is read", shown(least.text())));
}

void check_extensions(const gltf_value& root) {
    for (std::size_t i = 0; i < root.count("extensionsRequired"); ++i) {
        const std::string_view name = root["extensionsRequired"].at(i).text();
        if (!name.starts_with("KHR_materials_") &&
            std::ranges::find(readable_extensions, name) == std::end(readable_extensions))
            throw scene_error(
                fmt::format("needs the extension '{}', which is not read; export it without", shown(name)));
    }
}

glm::dvec3 row_of(const gltf_accessor& from, std::size_t row) {
    return {from.at(row, 0), from.at(row, 1), from.at(row, 2)};
}

/// Transforms of the instances of a node, relative to it.
class instances {
public:
    instances(const gltf_value& node, gltf_accessors& accessors) {
        if (!node.has("extensions") || !node["extensions"].has(instancing))
            return;
        const gltf_value attributes = node["extensions"][instancing]["attributes"];
        std::optional<std::size_t> rows;
        const auto read = [&](const char* name, std::size_t columns) -> const gltf_accessor* {
            if (!attributes.has(name))
                return nullptr;
            const gltf_accessor& found = accessors.read(attributes[name]);
            if (found.columns() != columns || rows.value_or(found.rows()) != found.rows())
                attributes[name].fail(fmt::format("must have {} numbers for each instance", columns));
            rows = found.rows();
            return &found;
        };
        translations_ = read("TRANSLATION", 3);
        rotations_ = read("ROTATION", 4);
        scales_ = read("SCALE", 3);
        count_ = rows.value_or(1);
    }

    std::size_t count() const { return count_; }

    glm::dmat4 at(std::size_t i) const {
        glm::dquat rotation(1, 0, 0, 0);
        if (rotations_)
            rotation = glm::normalize(glm::dquat(rotations_->at(i, 3), rotations_->at(i, 0),
                                                 rotations_->at(i, 1), rotations_->at(i, 2)));
        return transform(translations_ ? row_of(*translations_, i) : glm::dvec3(0), rotation,
                         scales_ ? row_of(*scales_, i) : glm::dvec3(1));
    }

private:
    std::size_t count_ = 1;
    const gltf_accessor *translations_ = nullptr, *rotations_ = nullptr, *scales_ = nullptr;
};

std::vector<double> weights_of(const gltf_value& of) {
    return of.has("weights") ? of["weights"].numbers(of["weights"].size()) : std::vector<double>();
}

/// A primitive of a mesh, and what it is of.
struct painted_primitive : gltf_primitive {
    material with;
};

/// A mesh of the file.
struct part {
    std::vector<painted_primitive> primitives;
    std::vector<double> weights; ///< of the morph targets
};

/// The joints that move a mesh.
struct skin {
    std::vector<std::size_t> joints; ///< nodes
    const gltf_accessor* inverse_bind = nullptr;
};

/// A mesh and what a node makes of it.
struct placed_part {
    const part& shape;
    instances copies;
    std::vector<double> own_weights; ///< none: those of the mesh
    const skin* moved_by = nullptr;

    const std::vector<double>& weights() const { return own_weights.empty() ? shape.weights : own_weights; }

    /// How many of them all primitives and copies have together; not exact above 2^53.
    template <typename Count>
    double all(Count count) const {
        double sum = 0;
        for (const gltf_primitive& p : shape.primitives)
            sum += static_cast<double>(count(p));
        return sum * static_cast<double>(copies.count());
    }

    double steps() const {
        const double joints = moved_by ? static_cast<double>(moved_by->joints.size()) : 0;
        return joints + static_cast<double>(copies.count()) + all([&](const gltf_primitive& p) {
                   const std::size_t moves = weights().size() + (moved_by ? 4 * p.influences.size() : 0);
                   return p.positions->rows() * (1 + moves);
               });
    }
};

class reader {
public:
    reader(const gltf_value& root, gltf_buffers& buffers)
        : root_(root), accessors_(root, buffers), nodes_(read_gltf_nodes(root)) {}

    mesh read() {
        make_room();
        for (const std::size_t node : nodes_.shown) {
            const gltf_value of = root_["nodes"].at(node);
            close(nodes_.depth[node]);
            open_.push_back(
                {node, result_.triangles(), nodes_.animated[node] || (!open_.empty() && open_.back().moves)});
            if (!of.has("mesh"))
                continue;
            add(node);
            if (open_.back().moves || of.has("skin"))
                set_dynamic(result_, open_.back().first, result_.triangles());
        }
        close(0);
        return std::move(result_);
    }

private:
    /// A node of which the triangles of all below it are to come.
    struct open_node {
        std::size_t node, first;
        bool moves;
    };

    /// Names the triangles of the open nodes from a depth on.
    void close(std::size_t depth) {
        while (!open_.empty() && nodes_.depth[open_.back().node] >= depth) {
            const gltf_value of = root_["nodes"].at(open_.back().node);
            if (of.has("name") && open_.back().first < result_.triangles())
                result_.named.push_back(
                    {std::string(of["name"].text()), open_.back().first, result_.triangles()});
            open_.pop_back();
        }
    }

    void make_room() {
        double vertices = 0, triangles = 0, steps = 0;
        for (const std::size_t node : nodes_.shown) {
            if (!root_["nodes"].at(node).has("mesh"))
                continue;
            const placed_part placed = place(node);
            vertices += placed.all([](const gltf_primitive& p) { return p.positions->rows(); });
            triangles += placed.all([](const gltf_primitive& p) { return p.triangles; });
            steps += placed.steps();
        }
        check(vertices, most_vertices, "vertices");
        check(triangles, most_triangles, "triangles");
        check(steps, most_placing_steps, "steps of instances, morph targets and joints");
        result_.positions.reserve(static_cast<std::size_t>(vertices));
        result_.indices.reserve(3 * static_cast<std::size_t>(triangles));
        result_.material_ids.reserve(static_cast<std::size_t>(triangles));
    }

    static void check(double count, std::size_t most, std::string_view what) {
        if (count > static_cast<double>(most))
            throw scene_error(
                fmt::format("has {:.0f} {} where all its meshes stand, and at most {} are read; "
                            "simplify it",
                            count, what, most));
    }

    placed_part place(std::size_t node) {
        const gltf_value of = root_["nodes"].at(node);
        const part& shape = part_at(of["mesh"]);
        placed_part placed{
            .shape = shape, .copies = instances(of, accessors_), .own_weights = weights_of(of)};
        if (of.has("skin"))
            placed.moved_by = &skin_at(of["skin"]);
        if (placed.moved_by && placed.copies.count() != 1)
            of.fail("has both a skin and instances, which is not read");
        return placed;
    }

    const part& part_at(const gltf_value& reference) {
        const std::size_t i = reference.index(root_.count("meshes"));
        const auto [place, is_new] = parts_.try_emplace(i);
        if (is_new) {
            const gltf_value of = root_["meshes"].at(i);
            place->second.weights = weights_of(of);
            for (std::size_t k = 0; k < of["primitives"].size(); ++k)
                add_primitive(of["primitives"].at(k), place->second);
        }
        return place->second;
    }

    void add_primitive(const gltf_value& of, part& to) {
        gltf_primitive made = read_gltf_primitive(of, accessors_);
        std::optional<material> with = material();
        if (of.has("material"))
            with = material_at(of["material"]);
        if (made.triangles > 0 && with)
            to.primitives.push_back({std::move(made), *with});
    }

    const std::optional<material>& material_at(const gltf_value& reference) {
        const std::size_t i = reference.index(root_.count("materials"));
        const auto [place, is_new] = materials_.try_emplace(i);
        if (is_new)
            place->second = read_gltf_material(root_["materials"].at(i));
        return place->second;
    }

    const skin& skin_at(const gltf_value& reference) {
        const std::size_t i = reference.index(root_.count("skins"));
        const auto [place, is_new] = skins_.try_emplace(i);
        if (is_new) {
            const gltf_value of = root_["skins"].at(i), joints = of["joints"];
            for (std::size_t k = 0; k < joints.size(); ++k)
                place->second.joints.push_back(joints.at(k).index(nodes_.to_world.size()));
            if (of.has("inverseBindMatrices")) {
                const gltf_accessor& matrices = accessors_.read(of["inverseBindMatrices"]);
                if (!matrices.is_float() || matrices.columns() != 16 || matrices.rows() < joints.size())
                    of["inverseBindMatrices"].fail("must have a matrix of floats for each joint");
                place->second.inverse_bind = &matrices;
            }
        }
        return place->second;
    }

    /// Of each joint, from the mesh to the world.
    std::vector<glm::dmat4> pose(const skin& of) const {
        std::vector<glm::dmat4> all;
        for (std::size_t i = 0; i < of.joints.size(); ++i) {
            glm::dmat4 bind(1);
            for (std::size_t k = 0; of.inverse_bind && k < 16; ++k)
                bind[static_cast<int>(k / 4)][static_cast<int>(k % 4)] = of.inverse_bind->at(i, k);
            all.push_back(nodes_.to_world[of.joints[i]] * bind);
        }
        return all;
    }

    void add(std::size_t node) {
        const placed_part placed = place(node);
        const std::vector<glm::dmat4> joints =
            placed.moved_by ? pose(*placed.moved_by) : std::vector<glm::dmat4>();
        for (std::size_t copy = 0; copy < placed.copies.count(); ++copy)
            for (const painted_primitive& shape : placed.shape.primitives) {
                add(shape, placed.weights(), joints, nodes_.to_world[node] * placed.copies.at(copy));
                paint(result_, shape.with);
            }
    }

    void add(const gltf_primitive& shape, const std::vector<double>& weights,
             const std::vector<glm::dmat4>& joints, const glm::dmat4& to_world) {
        const std::size_t first = result_.positions.size();
        for (std::size_t vertex = 0; vertex < shape.positions->rows(); ++vertex) {
            glm::dvec3 position = row_of(*shape.positions, vertex);
            for (std::size_t i = 0; i < std::min(weights.size(), shape.targets.size()); ++i)
                if (shape.targets[i] && weights[i] != 0)
                    position += weights[i] * row_of(*shape.targets[i], vertex);
            result_.positions.emplace_back(moved(shape, vertex, joints, to_world) * glm::dvec4(position, 1));
        }
        // A mirrored mesh keeps its front: glTF 2.0, 3.7.4.
        const bool is_mirrored = joints.empty() && glm::determinant(glm::dmat3(to_world)) < 0;
        for (std::size_t i = 0; i < shape.triangles; ++i) {
            auto [a, b, c] = shape.triangle(i);
            if (is_mirrored)
                std::swap(b, c);
            add_triangle(result_, static_cast<std::uint32_t>(first + a),
                         static_cast<std::uint32_t>(first + b), static_cast<std::uint32_t>(first + c));
        }
    }

    /// The transform of a vertex: of its joints, weighted, or where none has a weight, of its node.
    static glm::dmat4 moved(const gltf_primitive& shape, std::size_t vertex,
                            const std::vector<glm::dmat4>& joints, const glm::dmat4& to_world) {
        glm::dmat4 sum(0);
        double weights = 0;
        for (std::size_t i = 0; !joints.empty() && i < shape.influences.size(); ++i)
            for (std::size_t k = 0; k < 4; ++k) {
                const double weight = shape.influences[i].weights->at(vertex, k),
                             joint = shape.influences[i].joints->at(vertex, k);
                if (weight == 0)
                    continue;
                if (!(joint >= 0 && joint < static_cast<double>(joints.size())))
                    shape.source.fail(
                        fmt::format("uses joint {} of a skin that has {}", joint, joints.size()));
                sum += weight * joints[static_cast<std::size_t>(joint)];
                weights += weight;
            }
        return weights == 0 ? to_world : sum / weights;
    }

    const gltf_value& root_;
    gltf_accessors accessors_;
    gltf_nodes nodes_;
    std::map<std::size_t, part> parts_;
    std::map<std::size_t, skin> skins_;
    std::map<std::size_t, std::optional<material>> materials_;
    std::vector<open_node> open_;
    mesh result_;
};

}

mesh read_gltf(std::string_view file, const std::filesystem::path* folder) {
    const gltf_container parts = open_gltf(file);
    const nlohmann::json json = parse_gltf_json(parts.json);
    const gltf_value root(json);
    check_version(root);
    check_extensions(root);
    gltf_buffers buffers(root, parts.data, folder);
    return reader(root, buffers).read();
}

}
