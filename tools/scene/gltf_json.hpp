// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace crease::tools {

/// The JSON of a glTF file, within limits of depth and number of values.
/// @throws scene_error
nlohmann::json parse_gltf_json(std::string_view text);

/// A value of that JSON and its place, such as "accessors[3].count", which complaints begin with. Whatever is
/// missing or of another type than asked for throws a `scene_error`.
class gltf_value {
public:
    explicit gltf_value(const nlohmann::json& json, std::string place = "")
        : json_(&json), place_(std::move(place)) {}

    /// Whether this object has a member of that name.
    bool has(const char* member) const;
    /// A member of this object.
    gltf_value operator[](const char* member) const;

    /// How many elements this list has.
    std::size_t size() const;
    /// How many elements the list of that name has; 0 where there is none.
    std::size_t count(const char* member) const;
    /// An element of this list.
    gltf_value at(std::size_t i) const;

    std::string_view text() const;
    bool flag() const;
    double number() const;
    /// From 0 to 2^53.
    std::size_t whole() const;
    /// An index into a list of `size` elements.
    std::size_t index(std::size_t size) const;
    /// A list of exactly so many numbers.
    std::vector<double> numbers(std::size_t count) const;

    /// @param sentence  what is wrong with this value; follows its place
    [[noreturn]] void fail(std::string_view sentence) const;

private:
    const nlohmann::json* json_;
    std::string place_;
};

}
