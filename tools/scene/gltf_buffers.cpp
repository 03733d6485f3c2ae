// SPDX-License-Identifier: MIT
#include "scene/gltf_buffers.hpp"

#include "image/file.hpp"
#include "scene/limits.hpp"
#include "scene/scene.hpp"
#include "scene/shown.hpp"
#include "scene/uri.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>

namespace crease::tools {
namespace {

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

/// Takes the first chunk off `rest`.
std::string_view take_chunk(std::string_view& rest, std::string_view kind) {
    constexpr std::size_t header = 8; // length and kind
    if (rest.size() < header || rest.substr(4, 4) != kind)
        throw scene_error(fmt::format("is broken: its {} chunk is missing; export it again",
                                      kind.substr(0, kind.find('\0'))));
    const std::uint32_t length = little_endian(rest, 0);
    if (length > rest.size() - header)
        throw scene_error(
            fmt::format("is broken: its {} chunk declares {} bytes, and {} are there; export it again",
                        kind.substr(0, kind.find('\0')), length, rest.size() - header));
    const std::string_view content = rest.substr(header, length);
    rest.remove_prefix(header + length);
    return content;
}

/// The first bytes of a file, of which there must be so many.
std::string read_front(const std::filesystem::path& path, std::size_t length) {
    std::error_code error;
    const std::uintmax_t size =
        std::filesystem::is_regular_file(path, error) ? std::filesystem::file_size(path, error) : 0;
    if (size < length)
        throw scene_error(size == 0
                              ? fmt::format("needs the file '{}', which is not there", shown(path.string()))
                              : fmt::format("needs {} bytes of the file '{}', which has {}", length,
                                            shown(path.string()), size));
    std::string content(length, '\0');
    if (!std::ifstream(path, std::ios::binary).read(content.data(), static_cast<std::streamsize>(length)))
        throw scene_error(fmt::format("needs the file '{}', which cannot be read", shown(path.string())));
    return content;
}

}

gltf_container open_gltf(std::string_view file) {
    if (!file.starts_with("glTF"))
        return {.json = file, .data = {}};
    constexpr std::size_t header = 12; // magic, version, length
    if (file.size() < header)
        throw scene_error("is broken: it ends in its first 12 bytes; export it again");
    if (const std::uint32_t version = little_endian(file, 4); version != 2)
        throw scene_error(fmt::format("is glTF of version {}; only version 2 is read", version));
    const std::uint32_t length = little_endian(file, 8);
    if (length > file.size() || length < header)
        throw scene_error(fmt::format("is broken: it declares {} bytes, and {} are there; export it again",
                                      length, file.size()));
    std::string_view rest = file.substr(header, length - header);
    gltf_container parts;
    parts.json = take_chunk(rest, "JSON");
    if (!rest.empty() && rest.substr(4, 4) == std::string_view("BIN\0", 4))
        parts.data = take_chunk(rest, std::string_view("BIN\0", 4));
    return parts;
}

gltf_buffers::gltf_buffers(const gltf_value& root, std::optional<std::string_view> data,
                           const std::filesystem::path* folder)
    : root_(root), data_(data), folder_(folder), read_(root.count("buffers")) {}

gltf_buffers::view gltf_buffers::buffer_view(std::size_t i) {
    const gltf_value of = root_["bufferViews"].at(i);
    const std::string_view all = buffer(of["buffer"].index(read_.size()));
    const std::size_t length = of["byteLength"].whole(),
                      offset = of.has("byteOffset") ? of["byteOffset"].whole() : 0;
    if (offset > all.size() || length > all.size() - offset)
        of.fail(fmt::format("ends at byte {} of a buffer of {}", offset + length, all.size()));
    view found{.bytes = all.substr(offset, length)};
    if (of.has("byteStride"))
        found.stride = of["byteStride"].index(256);
    return found;
}

std::string_view gltf_buffers::buffer(std::size_t i) {
    const gltf_value of = root_["buffers"].at(i);
    const std::size_t length = of["byteLength"].whole();
    if (!of.has("uri")) {
        if (i != 0 || !data_)
            of.fail("has no data");
        if (length > data_->size())
            of.fail(fmt::format("declares {} bytes, and the file has {}", length, data_->size()));
        return data_->substr(0, length);
    }
    if (!read_[i])
        read_[i] = read_uri(of, length);
    return *read_[i];
}

std::string gltf_buffers::read_uri(const gltf_value& buffer, std::size_t length) {
    if (length > most_file_bytes - bytes_read_)
        throw scene_error(fmt::format("its buffers have more than {} bytes; simplify it", most_file_bytes));
    bytes_read_ += length;
    const std::string_view uri = buffer["uri"].text();
    if (uri.starts_with("data:")) {
        const std::size_t comma = uri.find(',');
        if (comma == uri.npos || !uri.substr(0, comma).ends_with(";base64"))
            buffer["uri"].fail("must be base64 where it is data");
        std::string bytes = base64_decoded(uri.substr(comma + 1));
        if (bytes.size() < length)
            buffer.fail(fmt::format("declares {} bytes, and its data has {}", length, bytes.size()));
        bytes.resize(length);
        return bytes;
    }
    if (!folder_)
        buffer["uri"].fail(fmt::format("is the file '{}', and no further file is read here", shown(uri)));
    const std::string file = percent_decoded(uri);
    if (file.find('\0') != file.npos)
        buffer["uri"].fail("must not have a zero byte");
    return read_front(*folder_ / std::u8string(file.begin(), file.end()), length);
}

}
