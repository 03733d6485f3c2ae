// SPDX-License-Identifier: MIT
#include "scene/gltf_buffers.hpp"

#include "expect_error.hpp"
#include "gltf_file.hpp"
#include "scene/scene.hpp"
#include "temporary_folder.hpp"

using namespace crease::tools;

namespace {

std::string chunk(const std::string& kind, const std::string& content, std::size_t length) {
    return little_endian(length) + kind + content;
}

std::string container(const std::string& chunks, std::size_t version = 2) {
    return "glTF" + little_endian(version) + little_endian(12 + chunks.size()) + chunks;
}

/// The bytes of the first buffer view.
std::string read(const std::string& json, const std::filesystem::path* folder = nullptr,
                 std::optional<std::string_view> data = {}) {
    const nlohmann::json parsed = nlohmann::json::parse(json);
    const gltf_value root(parsed);
    return std::string(gltf_buffers(root, data, folder).buffer_view(0).bytes);
}

std::string buffer(const std::string& uri, std::size_t length,
                   const std::string& view = R"("byteLength": 2)") {
    return R"({"buffers": [{"uri": ")" + uri + R"(", "byteLength": )" + std::to_string(length) +
           R"(}], "bufferViews": [{"buffer": 0, )" + view + "}]}";
}

}

TEST_CASE("glTF buffers: the chunks of a .glb, and what it declares and has not") {
    const std::string json = "{}  ", bin("BIN\0", 4);
    CHECK(open_gltf("{}").json == "{}");
    CHECK(!open_gltf("{}").data);
    const std::string one = container(chunk("JSON", json, 4)),
                      two = container(chunk("JSON", json, 4) + chunk(bin, "12345678", 8));
    CHECK(open_gltf(one).json == json);
    CHECK(!open_gltf(one).data);
    CHECK(open_gltf(two).data == "12345678");
    expect_error<scene_error>("it ends in its first 12 bytes", [] { open_gltf("glTF2"); });
    expect_error<scene_error>("is glTF of version 1; only version 2 is read",
                              [&] { open_gltf(container(chunk("JSON", json, 4), 1)); });
    expect_error<scene_error>("it declares 24 bytes, and 23 are there",
                              [&] { open_gltf(std::string_view(one).substr(0, 23)); });
    expect_error<scene_error>("its JSON chunk declares 4294967280 bytes, and 4 are there",
                              [&] { open_gltf(container(chunk("JSON", json, 0xfffffff0))); });
    expect_error<scene_error>("its BIN chunk declares 16 bytes, and 8 are there", [&] {
        open_gltf(container(chunk("JSON", json, 4) + chunk(bin, "12345678", 16)));
    });
    expect_error<scene_error>("its JSON chunk is missing",
                              [&] { open_gltf(container(chunk(bin, "1234", 4))); });
    expect_error<scene_error>("its JSON chunk is missing", [&] { open_gltf(container("")); });
}

TEST_CASE("glTF buffers: data URIs") {
    CHECK(read(buffer("data:application/octet-stream;base64,QUJD", 3)) == "AB");
    CHECK(read(buffer("data:;base64,QUJD", 3, R"("byteOffset": 1, "byteLength": 2)")) == "BC");
    expect_error<scene_error>("buffers[0] declares 4 bytes, and its data has 3",
                              [] { read(buffer("data:;base64,QUJD", 4)); });
    expect_error<scene_error>("buffers[0].uri must be base64 where it is data",
                              [] { read(buffer("data:text/plain,QUJD", 4)); });
    expect_error<scene_error>("a data URI is not base64", [] { read(buffer("data:;base64,Q.JD", 3)); });
    expect_error<scene_error>("bufferViews[0] ends at byte 4 of a buffer of 3", [] {
        read(buffer("data:;base64,QUJD", 3, R"("byteOffset": 2, "byteLength": 2)"));
    });
    expect_error<scene_error>("bufferViews[0] ends at byte", [] {
        read(buffer("data:;base64,QUJD", 3, R"("byteOffset": 9, "byteLength": 2)"));
    });
    expect_error<scene_error>("its buffers have more than 1073741824 bytes",
                              [] { read(buffer("data:;base64,QUJD", std::size_t{1} << 31)); });
}

TEST_CASE("glTF buffers: the binary chunk") {
    const std::string json =
        R"({"buffers": [{"byteLength": 3}, {"byteLength": 3}], "bufferViews": [{"buffer": 0, "byteLength": 3}]})";
    CHECK(read(json, nullptr, "ABCD") == "ABC");
    expect_error<scene_error>("buffers[0] declares 3 bytes, and the file has 2",
                              [&] { read(json, nullptr, "AB"); });
    expect_error<scene_error>("buffers[0] has no data", [&] { read(json); });
    expect_error<scene_error>("buffers[1] has no data", [&] {
        read(R"({"buffers": [{}, {"byteLength": 3}], "bufferViews": [{"buffer": 1, "byteLength": 3}]})",
             nullptr, "ABC");
    });
}

TEST_CASE("glTF buffers: further files, by percent-encoded names") {
    const temporary_folder folder;
    const std::filesystem::path here = folder.put("my buffer \xc3\xbc.bin", "ABCD").parent_path();
    CHECK(read(buffer("my%20buffer%20%C3%BC.bin", 3), &here) == "AB"); // the file may be longer than declared
    CHECK(read(buffer("my buffer \xc3\xbc.bin", 4), &here) == "AB");
    expect_error<scene_error>("needs 5 bytes of the file '" +
                                  (here / "my buffer \xc3\xbc.bin").string().substr(0, 50),
                              [&] { read(buffer("my%20buffer%20%C3%BC.bin", 5), &here); });
    expect_error<scene_error>("which is not there", [&] { read(buffer("absent.bin", 3), &here); });
    expect_error<scene_error>("which is not there", [&] { read(buffer("/dev/zero", 3), &here); });
    expect_error<scene_error>("which is not there", [&] { read(buffer("", 3), &here); });
    expect_error<scene_error>("a % without two hexadecimal digits", [&] { read(buffer("a%2", 3), &here); });
    expect_error<scene_error>("buffers[0].uri must not have a zero byte",
                              [&] { read(buffer("a%00", 3), &here); });
    expect_error<scene_error>("buffers[0].uri is the file 'a.bin', and no further file is read here",
                              [] { read(buffer("a.bin", 3)); });
}
