// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gltf_buffers.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace crease::tools {

/// Rows of numbers where they stand in a buffer.
class gltf_accessor {
public:
    std::size_t rows() const { return rows_; }
    std::size_t columns() const { return columns_; }
    bool has_data() const { return !bytes_.empty() || !sparse_rows_.empty(); }
    bool is_float() const;

    /// A number as it is meant: integers that are "normalized" are fractions of their greatest value.
    double at(std::size_t row, std::size_t column) const;

private:
    friend class gltf_accessors;

    std::size_t rows_ = 0, columns_ = 0, component_ = 0;
    bool normalized_ = false;
    std::string_view bytes_; ///< from the first row; empty where all rows are 0
    std::size_t stride_ = 0;
    std::vector<std::size_t>
        sparse_rows_; ///< ascending: the rows that stand in `sparse_bytes_`, without gaps
    std::string_view sparse_bytes_;
};

/// The accessors of a file, each checked once against the bytes that there are.
class gltf_accessors {
public:
    /// Both outlive this.
    gltf_accessors(const gltf_value& root, gltf_buffers& buffers);

    /// @param reference  an index into "accessors"
    /// @throws scene_error
    const gltf_accessor& read(const gltf_value& reference);

private:
    gltf_accessor read(std::size_t i);

    const gltf_value& root_;
    gltf_buffers& buffers_;
    std::vector<std::optional<gltf_accessor>> read_;
    std::size_t sparse_rows_ = 0; ///< of all that are read
};

}
