// SPDX-License-Identifier: MIT
#include "image/file.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace crease::tools {
namespace {

using nlohmann::json;

constexpr unsigned longest_picture_side = 16384;

/// Reads the fields of one camera; every complaint names the file, the camera and the field.
class camera_reader {
public:
    camera_reader(const json& object, std::string where) : object_(object), where_(std::move(where)) {}

    camera read() {
        camera c;
        c.name = text("name");
        where_ = fmt::format("{} ('{}')", where_, c.name);
        c.eye = vector("eye");
        c.target = vector("target");
        c.up = vector("up");
        c.vfov_deg = number("vfov_deg");
        c.near = number("near");
        c.far = number("far");
        c.width = side("width");
        c.height = side("height");
        c.ao_radius = number("ao_radius");
        check(c);
        return c;
    }

private:
    void require(bool holds, std::string_view field, std::string_view sentence) const {
        if (!holds)
            throw scene_error(fmt::format("{}: \"{}\" {}", where_, field, sentence));
    }

    const json& value(const char* field) const {
        require(object_.contains(field), field, "is missing");
        return object_[field];
    }

    std::string text(const char* field) const {
        const json& v = value(field);
        require(v.is_string() && !v.get_ref<const std::string&>().empty(), field,
                "must be a text that is not empty");
        return v.get<std::string>();
    }

    float finite(const json& v, const char* field, std::string_view sentence) const {
        require(v.is_number(), field, sentence);
        const auto n = v.get<float>();
        require(std::isfinite(n), field, sentence);
        return n;
    }

    float number(const char* field) const { return finite(value(field), field, "must be a finite number"); }

    glm::vec3 vector(const char* field) const {
        constexpr std::string_view sentence = "must be three finite numbers, [x, y, z]";
        const json& v = value(field);
        require(v.is_array() && v.size() == 3, field, sentence);
        return {finite(v[0], field, sentence), finite(v[1], field, sentence), finite(v[2], field, sentence)};
    }

    unsigned side(const char* field) const {
        const json& v = value(field);
        const auto texels = v.is_number_unsigned() ? v.get<std::uint64_t>() : 0;
        require(texels >= 1 && texels <= longest_picture_side, field,
                fmt::format("must be a whole number from 1 to {}", longest_picture_side));
        return static_cast<unsigned>(texels);
    }

    void check(const camera& c) const {
        const glm::dvec3 forward = glm::dvec3(c.target) - glm::dvec3(c.eye), up(c.up);
        require(forward != glm::dvec3(0), "target", "must differ from \"eye\"");
        require(up != glm::dvec3(0), "up", "must not be [0, 0, 0]");
        require(glm::length(glm::cross(glm::normalize(forward), glm::normalize(up))) > 1e-4, "up",
                "must not be parallel to the view, from \"eye\" to \"target\"");
        require(c.vfov_deg > 0 && c.vfov_deg < 180, "vfov_deg", "must be between 0 and 180, both excluded");
        require(c.near > 0, "near", "must be greater than 0");
        require(c.far > c.near, "far", "must be greater than \"near\"");
        require(c.ao_radius >= 0, "ao_radius", "must not be negative");
    }

    const json& object_;
    std::string where_;
};

}

std::vector<camera> load_cameras(const std::filesystem::path& path) {
    return parse_cameras(read_file(path), path.string());
}

std::vector<camera> parse_cameras(std::string_view text, std::string_view name) {
    json list;
    try {
        list = json::parse(text);
    } catch (const json::exception& error) {
        throw scene_error(fmt::format("{}: not JSON: {}", name, error.what()));
    }
    if (!list.is_array() || list.empty())
        throw scene_error(
            fmt::format("{}: must be a list of at least one camera, [{{\"name\": ...}}]", name));
    std::vector<camera> cameras;
    for (const json& object : list) {
        const std::string where = fmt::format("{}: camera {}", name, cameras.size());
        if (!object.is_object())
            throw scene_error(fmt::format("{}: must be an object, {{\"name\": ...}}", where));
        camera next = camera_reader(object, where).read();
        if (std::ranges::find(cameras, next.name, &camera::name) != cameras.end())
            throw scene_error(
                fmt::format("{}: \"name\" '{}' is taken by an earlier camera", where, next.name));
        cameras.push_back(std::move(next));
    }
    return cameras;
}

const camera& find_camera(std::span<const camera> cameras, std::string_view name) {
    const auto found = std::ranges::find(cameras, name, &camera::name);
    if (found != cameras.end())
        return *found;
    std::string names;
    for (const camera& c : cameras)
        names += (names.empty() ? "" : ", ") + c.name;
    throw scene_error(fmt::format("there is no camera '{}'; there are: {}", name, names));
}

glm::mat4 view_matrix(const camera& from) {
    return glm::lookAt(from.eye, from.target, from.up);
}

}
