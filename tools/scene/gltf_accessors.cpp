// SPDX-License-Identifier: MIT
#include "scene/gltf_accessors.hpp"

#include "scene/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

namespace crease::tools {
namespace {

enum component : std::size_t { int8 = 5120, uint8, int16, uint16, uint32 = 5125, float32 };

std::size_t bytes_of(std::size_t component) {
    switch (component) {
    case int8:
    case uint8:
        return 1;
    case int16:
    case uint16:
        return 2;
    default:
        return 4;
    }
}

template <typename T>
double number_at(const char* bytes, bool normalized) {
    T value;
    std::memcpy(&value, bytes, sizeof value); // glTF is little-endian, as is every machine that runs this
    if (!normalized)
        return static_cast<double>(value);
    return std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

double number_at(const char* bytes, std::size_t component, bool normalized) {
    switch (component) {
    case int8:
        return number_at<std::int8_t>(bytes, normalized);
    case uint8:
        return number_at<std::uint8_t>(bytes, normalized);
    case int16:
        return number_at<std::int16_t>(bytes, normalized);
    case uint16:
        return number_at<std::uint16_t>(bytes, normalized);
    case uint32:
        return number_at<std::uint32_t>(bytes, normalized);
    default:
        return number_at<float>(bytes, false);
    }
}

std::size_t component_of(const gltf_value& value) {
    const std::size_t component = value.whole();
    if (component < int8 || component > float32 || component == 5124)
        value.fail("must be a component type, 5120 to 5123, 5125 or 5126");
    return component;
}

std::size_t columns_of(const gltf_value& value) {
    constexpr struct {
        std::string_view name;
        std::size_t columns;
    } types[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    for (const auto& type : types)
        if (type.name == value.text())
            return type.columns;
    value.fail("must be SCALAR, VEC2, VEC3, VEC4 or MAT4 where it is used");
}

/// The bytes that `rows` of `row` bytes each take, from the offset that `place` names on.
std::string_view rows_in(std::string_view bytes, const gltf_value& place, std::size_t rows, std::size_t row,
                         std::size_t stride) {
    const std::size_t offset = place.has("byteOffset") ? place["byteOffset"].whole() : 0;
    const std::size_t taken = rows == 0 ? 0 : (rows - 1) * stride + row; // below 2^62, as rows are below 2^53
    if (offset > bytes.size() || taken > bytes.size() - offset)
        place.fail(fmt::format("ends at byte {} of a buffer view of {}", offset + taken, bytes.size()));
    return bytes.substr(offset, taken);
}

}

bool gltf_accessor::is_float() const {
    return component_ == float32;
}

double gltf_accessor::at(std::size_t row, std::size_t column) const {
    const std::size_t size = bytes_of(component_);
    const auto sparse = std::ranges::lower_bound(sparse_rows_, row);
    if (sparse != sparse_rows_.end() && *sparse == row) {
        const auto i = static_cast<std::size_t>(sparse - sparse_rows_.begin());
        return number_at(&sparse_bytes_[(i * columns_ + column) * size], component_, normalized_);
    }
    return bytes_.empty() ? 0 : number_at(&bytes_[row * stride_ + column * size], component_, normalized_);
}

gltf_accessors::gltf_accessors(const gltf_value& root, gltf_buffers& buffers)
    : root_(root), buffers_(buffers), read_(root.count("accessors")) {}

const gltf_accessor& gltf_accessors::read(const gltf_value& reference) {
    const std::size_t i = reference.index(read_.size());
    if (!read_[i])
        read_[i] = read(i);
    return *read_[i];
}

gltf_accessor gltf_accessors::read(std::size_t i) {
    const gltf_value of = root_["accessors"].at(i);
    gltf_accessor made;
    made.rows_ = of["count"].whole();
    made.columns_ = columns_of(of["type"]);
    made.component_ = component_of(of["componentType"]);
    made.normalized_ = of.has("normalized") && of["normalized"].flag();
    const std::size_t row = made.columns_ * bytes_of(made.component_);
    const std::size_t views = root_.count("bufferViews");
    if (of.has("bufferView")) {
        const gltf_buffers::view view = buffers_.buffer_view(of["bufferView"].index(views));
        made.stride_ = view.stride == 0 ? row : view.stride;
        made.bytes_ = rows_in(view.bytes, of, made.rows_, row, made.stride_);
    }
    if (!of.has("sparse"))
        return made;
    const gltf_value sparse = of["sparse"], indices = sparse["indices"], values = sparse["values"];
    const std::size_t replaced = sparse["count"].whole(), index = component_of(indices["componentType"]);
    const std::string_view index_bytes =
        rows_in(buffers_.buffer_view(indices["bufferView"].index(views)).bytes, indices, replaced,
                bytes_of(index), bytes_of(index));
    made.sparse_bytes_ =
        rows_in(buffers_.buffer_view(values["bufferView"].index(views)).bytes, values, replaced, row, row);
    sparse_rows_ += replaced;
    if (sparse_rows_ > most_vertices)
        sparse.fail(fmt::format("brings the sparse rows above {}", most_vertices));
    for (std::size_t k = 0; k < replaced; ++k) {
        const double at = number_at(&index_bytes[k * bytes_of(index)], index, false);
        const double least = k == 0 ? 0 : static_cast<double>(made.sparse_rows_.back()) + 1;
        if (!(at >= least && at < static_cast<double>(made.rows_)))
            sparse.fail("must have ascending indices below its count");
        made.sparse_rows_.push_back(static_cast<std::size_t>(at));
    }
    return made;
}

}
