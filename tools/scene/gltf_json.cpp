// SPDX-License-Identifier: MIT
#include "scene/gltf_json.hpp"

#include "scene/scene.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace crease::tools {

using nlohmann::json;

namespace {

/// JSON takes many times the memory of its text, by its values, and each bracket opens one level.
void check_limits(std::string_view text) {
    constexpr std::size_t deepest = 64, most_values = 3'000'000;
    std::size_t depth = 0, values = 1; // at most: one after each comma and in each bracket
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"')
            in_string = !in_string;
        else if (in_string)
            i += c == '\\';
        else if (c == '[' || c == '{')
            ++depth;
        else if ((c == ']' || c == '}') && depth > 0)
            --depth;
        values += !in_string && (c == ',' || c == '[' || c == '{');
        if (depth > deepest)
            throw scene_error(fmt::format("its JSON nests deeper than {} levels; export it again", deepest));
        if (values > most_values)
            throw scene_error(fmt::format("its JSON has more than {} values; simplify it", most_values));
    }
}

}

json parse_gltf_json(std::string_view text) {
    check_limits(text);
    try {
        return json::parse(text);
    } catch (const json::parse_error& error) {
        throw scene_error(
            fmt::format("is broken: its JSON cannot be read at byte {}; export it again", error.byte));
    } catch (const json::exception&) {
        throw scene_error("is broken: its JSON has a number that is out of range; export it again");
    }
}

bool gltf_value::has(const char* member) const {
    if (!json_->is_object())
        fail("must be an object");
    return json_->contains(member);
}

gltf_value gltf_value::operator[](const char* member) const {
    std::string place = place_.empty() ? member : fmt::format("{}.{}", place_, member);
    if (!has(member))
        throw scene_error(place + " is missing; export it again");
    return gltf_value(*json_->find(member), std::move(place));
}

std::size_t gltf_value::size() const {
    if (!json_->is_array())
        fail("must be a list");
    return json_->size();
}

std::size_t gltf_value::count(const char* member) const {
    return has(member) ? (*this)[member].size() : 0;
}

gltf_value gltf_value::at(std::size_t i) const {
    if (i >= size())
        fail(fmt::format("has {} elements, and element {} is asked for", size(), i));
    return gltf_value((*json_)[i], fmt::format("{}[{}]", place_, i));
}

std::string_view gltf_value::text() const {
    if (!json_->is_string())
        fail("must be a text");
    return json_->get_ref<const std::string&>();
}

bool gltf_value::flag() const {
    if (!json_->is_boolean())
        fail("must be true or false");
    return json_->get<bool>();
}

double gltf_value::number() const {
    if (!json_->is_number())
        fail("must be a number");
    return json_->get<double>();
}

std::size_t gltf_value::whole() const {
    constexpr double most = 0x1p53;
    const double value = json_->is_number() ? json_->get<double>() : -1;
    if (!(value >= 0 && value <= most && value == std::floor(value)))
        fail("must be a whole number that is not negative");
    return static_cast<std::size_t>(value);
}

std::size_t gltf_value::index(std::size_t size) const {
    const std::size_t value = whole();
    if (value >= size)
        fail(fmt::format("is {}, and there are only {}", value, size));
    return value;
}

std::vector<double> gltf_value::numbers(std::size_t count) const {
    if (size() != count)
        fail(fmt::format("must be a list of {} numbers", count));
    std::vector<double> all;
    for (std::size_t i = 0; i < count; ++i)
        all.push_back(at(i).number());
    return all;
}

void gltf_value::fail(std::string_view sentence) const {
    throw scene_error(fmt::format("{} {}; export it again", place_.empty() ? "its JSON" : place_, sentence));
}

}
