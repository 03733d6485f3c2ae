// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

/// Component types of accessors.
enum : int { gltf_int8 = 5120, gltf_uint8, gltf_int16, gltf_uint16, gltf_uint32 = 5125, gltf_float = 5126 };

inline std::string little_endian(std::size_t value) {
    std::string bytes;
    for (unsigned i = 0; i < 4; ++i)
        bytes += static_cast<char>(value >> 8 * i & 0xff);
    return bytes;
}

/// A .glb whose JSON a test changes before it is written. It begins as a tetrahedron's corner: two triangles
/// of four vertices, accessors 0 and 1, in one mesh of one node.
struct gltf_file {
    nlohmann::json json = nlohmann::json::parse(R"({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [], "bufferViews": [], "buffers": [{"byteLength": 0}]})");
    std::string data;

    gltf_file() {
        add<float>(gltf_float, "VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
        add<std::uint32_t>(gltf_uint32, "SCALAR", {0, 1, 2, 0, 2, 3});
    }

    /// Adds numbers with a buffer view of their own.
    /// @return the accessor's index
    template <typename T>
    std::size_t add(int component, const std::string& type, const std::vector<T>& numbers,
                    bool normalized = false) {
        const std::size_t offset = data.size(), size = numbers.size() * sizeof(T);
        data.resize(offset + (size + 3) / 4 * 4);
        std::memcpy(data.data() + offset, numbers.data(),
                    size); // as every machine that runs this is little-endian
        const std::size_t columns = type == "SCALAR" ? 1
                                    : type == "MAT4" ? 16
                                                     : static_cast<std::size_t>(type[3] - '0');
        json["accessors"].push_back({{"bufferView", json["bufferViews"].size()},
                                     {"componentType", component},
                                     {"type", type},
                                     {"count", numbers.size() / columns},
                                     {"normalized", normalized}});
        json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
        json["buffers"][0]["byteLength"] = data.size();
        return json["accessors"].size() - 1;
    }

    nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }

    std::string glb() const {
        std::string text = json.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        return "glTF" + little_endian(2) + little_endian(12 + 8 + text.size() + 8 + data.size()) +
               little_endian(text.size()) + "JSON" + text + little_endian(data.size()) +
               std::string("BIN\0", 4) + data;
    }
};
