// SPDX-License-Identifier: MIT
#include "scene/obj.hpp"

#include "image/file.hpp"
#include "scene/limits.hpp"
#include "scene/mtl.hpp"
#include "scene/obj_lines.hpp"
#include "scene/polygon.hpp"
#include "scene/shown.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace crease::tools {
namespace {

/// The vertex of a corner "v", "v/vt", "v//vn" or "v/vt/vn".
std::uint32_t vertex(const obj_lines& line, std::string_view corner, std::size_t above, std::size_t all) {
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(corner.data(), corner.data() + corner.size(), index);
    const bool is_read = error == std::errc() && (end == corner.data() + corner.size() || *end == '/');
    const std::int64_t place = index < 0 ? static_cast<std::int64_t>(above) + index : index - 1;
    if (!is_read || place < 0 || place >= static_cast<std::int64_t>(all))
        line.fail(fmt::format("'{}' is not one of the {} vertices", shown(corner), index < 0 ? above : all));
    return static_cast<std::uint32_t>(place);
}

std::vector<glm::dvec3> positions_of(std::string_view file) {
    std::vector<glm::dvec3> all;
    for (obj_lines line(file); line.next();) {
        if (line.word() != "v")
            continue;
        if (all.size() == most_vertices)
            throw scene_error(fmt::format("has more than {} vertices; simplify it", most_vertices));
        glm::dvec3& position = all.emplace_back();
        for (int i = 0; i < 3; ++i)
            position[i] = number_of(line, line.word(), "a vertex needs three numbers");
        for (std::string_view more = line.word(); !more.empty(); more = line.word())
            number_of(line, more, {}); // a weight or a colour
    }
    return all;
}

/// The materials of the libraries that a file names, each read once.
class libraries {
public:
    /// @param folder  where they are; null where none may be read
    explicit libraries(const std::filesystem::path* folder) : folder_(folder) {}

    void read(const obj_lines& line) {
        if (!folder_ || !read_.emplace(line.rest()).second)
            return;
        const std::filesystem::path file = *folder_ / line.rest();
        std::error_code absent;
        if (!std::filesystem::is_regular_file(file, absent))
            return;
        if (std::filesystem::file_size(file) > most_library_bytes)
            throw scene_error(fmt::format("needs '{}', which has more than {} bytes; simplify it",
                                          shown(line.rest()), most_library_bytes));
        try {
            materials_.merge(read_mtl(read_file(file)));
        } catch (const scene_error& error) {
            throw scene_error(fmt::format("needs '{}': {}", shown(line.rest()), error.what()));
        }
    }

    material named(std::string_view name) const {
        const auto found = materials_.find(name);
        return found == materials_.end() ? material() : found->second;
    }

private:
    const std::filesystem::path* folder_;
    std::set<std::string, std::less<>> read_;
    mtl_materials materials_;
};

/// The names under which the triangles of a file stand: those of an object, and those of groups.
class open_names {
public:
    explicit open_names(mesh& to) : to_(to) {}

    /// The words of a line are the names of what comes now.
    void begin(obj_lines& line) {
        end();
        first_ = to_.triangles();
        for (std::string_view name = line.word(); !name.empty(); name = line.word())
            names_.emplace_back(name);
    }

    void end() {
        if (first_ < to_.triangles())
            for (std::string& name : names_)
                to_.named.push_back({std::move(name), first_, to_.triangles()});
        names_.clear();
    }

private:
    mesh& to_;
    std::vector<std::string> names_;
    std::size_t first_ = 0;
};

}

mesh read_obj(std::string_view file, const std::filesystem::path* folder) {
    mesh made{.positions = positions_of(file)};
    triangulator polygons(made);
    libraries of_file(folder);
    material used;
    open_names of_object(made), of_groups(made);
    std::vector<std::uint32_t> face;
    std::size_t above = 0;
    for (obj_lines line(file); line.next();) {
        const std::string_view kind = line.word();
        above += kind == "v";
        if (kind == "mtllib")
            of_file.read(line);
        if (kind == "o")
            of_object.begin(line);
        if (kind == "g")
            of_groups.begin(line);
        if (kind == "usemtl") {
            paint(made, used);
            used = of_file.named(line.rest());
        }
        if (kind != "f")
            continue;
        face.clear();
        for (std::string_view corner = line.word(); !corner.empty(); corner = line.word())
            face.push_back(vertex(line, corner, above, made.positions.size()));
        polygons.add(face);
    }
    paint(made, used);
    of_object.end();
    of_groups.end();
    return made;
}

}
