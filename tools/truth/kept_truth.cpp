// SPDX-License-Identifier: MIT
#include "truth/kept_truth.hpp"

#include "image/file.hpp"
#include "image/file_set.hpp"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>

namespace crease::tools {
namespace {

namespace fs = std::filesystem;

/// A name for content, which other content has not.
class content_name {
public:
    template <class Element>
    void add(std::span<const Element> elements) {
        name_ = boost::uuids::name_generator_sha1(name_)(elements.data(), elements.size_bytes());
    }

    std::string text() const { return boost::uuids::to_string(name_); }

private:
    boost::uuids::uuid name_ = boost::uuids::ns::oid();
};

std::string name_of(const mesh& scene, const camera& from, const truth_settings& settings) {
    content_name name;
    name.add(std::span<const glm::dvec3>(scene.positions));
    name.add(std::span<const std::uint32_t>(scene.indices));
    const double numbers[] = {tracer_version,
                              from.eye.x,
                              from.eye.y,
                              from.eye.z,
                              from.target.x,
                              from.target.y,
                              from.target.z,
                              from.up.x,
                              from.up.y,
                              from.up.z,
                              from.vfov_deg,
                              from.near,
                              from.far,
                              from.orthographic ? 1.0 : 0.0,
                              from.shift.x,
                              from.shift.y,
                              static_cast<double>(settings.width),
                              static_cast<double>(settings.height),
                              settings.radius,
                              static_cast<double>(settings.rays),
                              static_cast<double>(settings.seed)};
    name.add(std::span<const double>(numbers));
    if (is_transparent(scene)) {
        std::vector<float> opacities{settings.hull ? 1.0f : 0.0f};
        for (std::size_t i = 0; i < scene.triangles(); ++i)
            opacities.push_back(scene.material_of(i).colour.a);
        name.add(std::span<const float>(opacities));
    }
    return name.text();
}

std::string name_of(const image& pixels) {
    content_name name;
    name.add(std::span<const float>(pixels.texels));
    return name.text();
}

struct part_of_truth {
    const char* file;
    image truth::*pixels;
};

std::vector<part_of_truth> parts_of(const truth_settings& settings) {
    std::vector<part_of_truth> parts{{"ao_hard.pfm", &truth::ao_hard}, {"ao_linear.pfm", &truth::ao_linear},
                                     {"ao_quad.pfm", &truth::ao_quad}, {"bent.pfm", &truth::bent},
                                     {"depth.pfm", &truth::depth},     {"normal.pfm", &truth::normal}};
    if (settings.first_layer)
        parts.push_back({"ao_first_layer.pfm", &truth::ao_first_layer});
    return parts;
}

constexpr const char* list_name = "content.json"; ///< the names of the pictures' contents

/// @throws std::runtime_error where something is missing or not as it was written
truth read(const fs::path& folder, const truth_settings& settings) {
    const nlohmann::json list = nlohmann::json::parse(read_file(folder / list_name));
    truth kept;
    for (const auto& [file, pixels] : parts_of(settings)) {
        kept.*pixels = read_pfm(folder / file);
        if (list.at(file) != name_of(kept.*pixels))
            throw image_error(fmt::format("{}: is not as it was written", (folder / file).string()));
    }
    return kept;
}

void write(const fs::path& folder, const truth& traced, const truth_settings& settings) {
    file_set files(folder);
    nlohmann::ordered_json list;
    for (const auto& [file, pixels] : parts_of(settings)) {
        write_pfm(files / file, traced.*pixels);
        list[file] = name_of(traced.*pixels);
    }
    write_atomically(files / list_name, list.dump(2) + "\n");
    files.appear();
}

/// A label as the name of a folder.
std::string plain(std::string label) {
    constexpr std::size_t longest = 60;
    const auto is_plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    };
    std::ranges::replace_if(
        label, [&](char c) { return !is_plain(c); }, '_');
    return label.substr(0, longest);
}

bool holds_other(const fs::path& directory, const std::string& beginning) {
    std::error_code ignored;
    const fs::directory_iterator entries(directory, ignored);
    return std::ranges::any_of(entries, [&](const fs::directory_entry& entry) {
        return entry.path().filename().string().starts_with(beginning);
    });
}

}

truth kept_truth(const fs::path& directory, const std::string& label, const mesh& scene, const camera& from,
                 const truth_settings& settings, const std::function<void(const std::string&)>& say) {
    const std::string beginning = plain(label) + ".";
    const fs::path folder = directory / (beginning + name_of(scene, from, settings));
    if (fs::exists(folder)) {
        try {
            return read(folder, settings);
        } catch (const std::exception& error) {
            say(fmt::format("{}; the truth of {} is traced anew", error.what(), label));
        }
    } else if (holds_other(directory, beginning)) {
        say(fmt::format(
            "the truths of {} in {} are of another scene, camera, size, radius or count of rays; it "
            "is traced anew",
            label, directory.string()));
    }
    const truth traced = trace_truth(scene, from, settings);
    write(folder, traced, settings);
    return traced;
}

}
