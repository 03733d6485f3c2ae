// SPDX-License-Identifier: MIT
#include "image/file.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>

namespace crease::tools {
namespace {

using nlohmann::json;

constexpr unsigned longest_picture_side = 16384;

/// The unit vector along `v`, however long that is; NaN where it is 0.
glm::dvec3 direction_of(const glm::dvec3& v) {
    const glm::dvec3 size = glm::abs(v);
    return glm::normalize(v / std::max({size.x, size.y, size.z}));
}

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
        check_names();
        check(c);
        return c;
    }

private:
    void require(bool holds, std::string_view field, std::string_view sentence) const {
        if (!holds)
            throw scene_error(fmt::format("{}: \"{}\" {}", where_, field, sentence));
    }

    void check_names() const {
        constexpr std::string_view known[] = {"name", "eye", "target", "up",     "vfov_deg",
                                              "near", "far", "width",  "height", "ao_radius"};
        for (const auto& [name, ignored] : object_.items())
            require(std::ranges::find(known, name) != std::end(known), name,
                    fmt::format("is unknown; a camera has {}", fmt::join(known, ", ")));
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

    double number_up_to(double most, const json& v, const char* field, std::string_view sentence) const {
        require(v.is_number(), field, sentence);
        const auto n = v.get<double>();
        require(std::abs(n) <= most, field, sentence); // false for NaN
        return n;
    }

    float number(const char* field) const {
        using limits = std::numeric_limits<float>;
        const std::string sentence =
            fmt::format("must be a number, 0 or {:.2g} to {:.2g} in size", limits::min(), limits::max());
        const double n = number_up_to(limits::max(), value(field), field, sentence);
        require(n == 0 || std::abs(n) >= limits::min(), field, sentence);
        return static_cast<float>(n);
    }

    glm::dvec3 vector(const char* field) const {
        const std::string sentence = fmt::format("must be three numbers, [x, y, z], each from {0:g} to {1:g}",
                                                 -farthest_coordinate, farthest_coordinate);
        const json& v = value(field);
        require(v.is_array() && v.size() == 3, field, sentence);
        glm::dvec3 read;
        for (unsigned i = 0; i < 3; ++i)
            read[static_cast<int>(i)] = number_up_to(farthest_coordinate, v[i], field, sentence);
        return read;
    }

    unsigned side(const char* field) const {
        const json& v = value(field);
        const auto texels = v.is_number_unsigned() ? v.get<std::uint64_t>() : 0;
        require(texels >= 1 && texels <= longest_picture_side, field,
                fmt::format("must be a whole number from 1 to {}", longest_picture_side));
        return static_cast<unsigned>(texels);
    }

    void check(const camera& c) const {
        require(c.target != c.eye, "target", "must differ from \"eye\"");
        require(c.up != glm::dvec3(0), "up", "must not be [0, 0, 0]");
        require(glm::length(glm::cross(direction_of(c.target - c.eye), direction_of(c.up))) > 1e-4, "up",
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
    std::set<std::string> names; // of the object that is read
    const auto once = [&](int, json::parse_event_t event, json& parsed) {
        if (event == json::parse_event_t::object_start)
            names.clear();
        if (event == json::parse_event_t::key && !names.insert(parsed.get<std::string>()).second)
            throw scene_error(fmt::format("{}: {} stands twice in one camera", name, parsed.dump()));
        return true;
    };
    try {
        list = json::parse(text, once);
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

camera fitted_camera(const mesh& scene) {
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const std::uint32_t i : scene.indices) {
        low = glm::min(low, scene.positions[i]);
        high = glm::max(high, scene.positions[i]);
    }
    const glm::dvec3 half = (high - low) / 2.0;
    const double size = std::max({half.x, half.y, half.z}), radius = size * glm::length(half / size);
    camera from;
    from.name = "fitted";
    const double distance = radius / std::sin(glm::radians(double{from.vfov_deg}) / 2);
    from.target = low + half;
    from.eye = from.target + distance * glm::normalize(glm::dvec3(2, 2, 3));
    from.near = static_cast<float>((distance - radius) / 2);
    from.far = static_cast<float>(2 * (distance + radius));
    from.ao_radius = static_cast<float>(radius / 10);
    return from;
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

view_window window_of(const camera& from, double aspect) {
    const double down = std::tan(glm::radians(double{from.vfov_deg}) / 2) *
                        (from.orthographic ? glm::length(from.target - from.eye) : 1);
    const glm::dvec2 half(down * aspect, down);
    return {2.0 * half * from.shift, half};
}

glm::dmat3 view_rotation(const camera& from) {
    const glm::dvec3 ahead = direction_of(from.target - from.eye);
    const glm::dvec3 right = direction_of(glm::cross(ahead, direction_of(from.up)));
    return glm::transpose(glm::dmat3(right, glm::cross(right, ahead), -ahead));
}

glm::dmat4 view_matrix(const camera& from) {
    glm::dmat4 view(view_rotation(from));
    view[3] = glm::dvec4(glm::dmat3(view) * -from.eye, 1);
    return view;
}

}
