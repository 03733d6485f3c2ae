// SPDX-License-Identifier: MIT
#include "image/file.hpp"
#include "scene/gltf_nodes.hpp"
#include "scene/scene.hpp"

#include <assimp/BaseImporter.h>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace crease::tools {
namespace {

/// More would not fit a GPU's buffers, and a small hostile file may repeat one mesh without end.
constexpr std::size_t most_vertices = std::size_t{1} << 28;

constexpr unsigned import_steps = aiProcess_Triangulate | aiProcess_RemoveComponent;

constexpr int unused_components = aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS |
                                  aiComponent_COLORS | aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS |
                                  aiComponent_ANIMATIONS | aiComponent_TEXTURES | aiComponent_LIGHTS |
                                  aiComponent_CAMERAS;

void check_extension(std::string_view extension, std::string_view name) {
    if (extension != "glb" && extension != "gltf" && extension != "obj")
        throw scene_error(
            fmt::format("{}: cannot read '.{}' scenes; use .glb, .gltf or .obj", name, extension));
}

bool is_near_enough(const glm::dvec3& p) {
    const auto holds = [](double x) { return std::abs(x) <= farthest_coordinate; }; // false for NaN
    return holds(p.x) && holds(p.y) && holds(p.z);
}

glm::dmat4 transform_of(const aiNode& node) {
    glm::dmat4 columns;
    for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column)
            columns[static_cast<int>(column)][static_cast<int>(row)] = node.mTransformation[row][column];
    return columns;
}

/// Collects the meshes of an imported scene into one.
class collector {
public:
    /// @param written  the nodes of the file, where it is a glTF
    collector(std::string_view name, const gltf_nodes& written) : name_(name), written_(written) {}

    void add(const aiScene& scene) {
        const gltf_nodes::node top = written_.top();
        add(scene, *scene.mRootNode, written_.roots.empty() ? nullptr : &top, glm::dmat4(1));
    }

    mesh take() { return std::move(result_); }

private:
    /// @param written  the same node in the file; null where it is not known
    void add(const aiScene& scene, const aiNode& node, const gltf_nodes::node* written,
             const glm::dmat4& parent) {
        if (written && written->children.size() != node.mNumChildren)
            written = nullptr;
        const glm::dmat4 world = parent * (written ? written->to_parent : transform_of(node));
        for (unsigned i = 0; i < node.mNumMeshes; ++i)
            add(*scene.mMeshes[node.mMeshes[i]], world);
        for (unsigned i = 0; i < node.mNumChildren; ++i)
            add(scene, *node.mChildren[i], written ? &written_.all[written->children[i]] : nullptr, world);
    }

    void add(const aiMesh& part, const glm::dmat4& world) {
        const std::size_t first = result_.positions.size();
        if (first + part.mNumVertices > most_vertices)
            throw scene_error(
                fmt::format("{}: has more than {} vertices; simplify it", name_, most_vertices));
        for (unsigned i = 0; i < part.mNumVertices; ++i) {
            const aiVector3D& p = part.mVertices[i];
            result_.positions.emplace_back(world * glm::dvec4(p.x, p.y, p.z, 1));
        }
        for (unsigned i = 0; i < part.mNumFaces; ++i)
            if (part.mFaces[i].mNumIndices == 3)
                add(part.mFaces[i], part.mNumVertices, first);
    }

    void add(const aiFace& face, unsigned vertices, std::size_t first) {
        std::array<std::uint32_t, 3> triangle;
        for (unsigned i = 0; i < 3; ++i) {
            if (face.mIndices[i] >= vertices)
                throw scene_error(
                    fmt::format("{}: a triangle uses vertex {} of a mesh that has {}; export it again", name_,
                                face.mIndices[i], vertices));
            triangle[i] = static_cast<std::uint32_t>(first + face.mIndices[i]);
        }
        const glm::dvec3 a = result_.positions[triangle[0]], b = result_.positions[triangle[1]],
                         c = result_.positions[triangle[2]];
        if (glm::cross(b - a, c - a) != glm::dvec3(0)) // true for NaN, which check_mesh reports
            result_.indices.insert(result_.indices.end(), triangle.begin(), triangle.end());
    }

    std::string name_;
    const gltf_nodes& written_;
    mesh result_;
};

/// Assimp would read a file of any format that it recognises, whatever the extension says.
void keep_known_formats(Assimp::Importer& importer) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        const std::string_view extensions = importer.GetImporterInfo(i)->mFileExtensions;
        if (extensions == "gltf glb" || extensions == "obj")
            continue;
        const std::unique_ptr<Assimp::BaseImporter> other(importer.GetImporter(i));
        importer.UnregisterLoader(other.get());
    }
}

/// While it lives, it listens whether Assimp drops triangles, which it tells nobody but its log.
class drop_listener {
public:
    drop_listener() {
        Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
        Assimp::DefaultLogger::get()->attachStream(new stream(dropped_),
                                                   Assimp::Logger::Warn); // takes it over
    }
    drop_listener(const drop_listener&) = delete;
    drop_listener& operator=(const drop_listener&) = delete;
    ~drop_listener() { Assimp::DefaultLogger::kill(); }

    bool dropped() const { return dropped_; }

private:
    struct stream final : Assimp::LogStream {
        explicit stream(bool& flag) : dropped(flag) {}
        void write(const char* message) override {
            dropped |= std::string_view(message).find("out-of-range indices") != std::string_view::npos;
        }
        bool& dropped;
    };
    bool dropped_ = false;
};

/// @param gltf  the bytes of the file, where it is a glTF
/// @param read  what reads the scene with an importer
template <typename Read>
mesh import(std::string_view gltf, std::string_view name, Read read) {
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, unused_components);
    keep_known_formats(importer);
    const drop_listener log;
    const aiScene* scene = read(importer);
    if (!scene || !scene->mRootNode)
        throw scene_error(
            fmt::format("{}: broken or unsupported scene: {}", name, importer.GetErrorString()));
    if (log.dropped())
        throw scene_error(
            fmt::format("{}: a triangle uses a vertex that its mesh does not have; export it again", name));
    const gltf_nodes written = read_gltf_nodes(gltf);
    collector all(name, written);
    all.add(*scene);
    mesh result = all.take();
    check_mesh(result, name);
    return result;
}

}

void check_mesh(const mesh& scene, std::string_view name) {
    if (scene.indices.size() < 3)
        throw scene_error(fmt::format("{}: has no triangles", name));
    if (scene.indices.size() % 3 != 0)
        throw scene_error(
            fmt::format("{}: has {} indices, which is not a multiple of 3", name, scene.indices.size()));
    const auto broken = std::find_if_not(scene.positions.begin(), scene.positions.end(), is_near_enough);
    if (broken != scene.positions.end())
        throw scene_error(
            fmt::format("{}: the position of vertex {} is not finite, or beyond {:g}; export it again", name,
                        broken - scene.positions.begin(), farthest_coordinate));
    const std::uint32_t last = *std::max_element(scene.indices.begin(), scene.indices.end());
    if (last >= scene.positions.size())
        throw scene_error(fmt::format("{}: a triangle uses vertex {} of a mesh that has {}; export it again",
                                      name, last, scene.positions.size()));
}

mesh load_mesh(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    check_extension(extension.empty() ? extension : extension.substr(1), path.string());
    if (!std::filesystem::is_regular_file(path))
        throw scene_error(fmt::format("{}: no such file", path.string()));
    const bool is_gltf = extension != ".obj";
    return import(is_gltf ? read_file(path) : std::string(), path.string(),
                  [&](Assimp::Importer& importer) { return importer.ReadFile(path.string(), import_steps); });
}

mesh parse_mesh(std::string_view bytes, std::string_view extension, std::string_view name) {
    check_extension(extension, name);
    return import(extension == "obj" ? std::string_view() : bytes, name,
                  [&, hint = std::string(extension)](Assimp::Importer& importer) {
                      return importer.ReadFileFromMemory(bytes.data(), bytes.size(), import_steps,
                                                         hint.c_str());
                  });
}

}
