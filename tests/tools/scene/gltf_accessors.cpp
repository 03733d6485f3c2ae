// SPDX-License-Identifier: MIT
#include "scene/gltf_accessors.hpp"

#include "expect_error.hpp"
#include "gltf_file.hpp"
#include "scene/scene.hpp"

using namespace crease::tools;

namespace {

/// All numbers of accessor `i`.
std::vector<double> numbers(const gltf_file& file, std::size_t i) {
    const gltf_value root(file.json);
    gltf_buffers buffers(root, file.data, nullptr);
    gltf_accessors all(root, buffers);
    const nlohmann::json reference = i;
    const gltf_accessor& read = all.read(gltf_value(reference, "this"));
    std::vector<double> found;
    for (std::size_t row = 0; row < read.rows(); ++row)
        for (std::size_t column = 0; column < read.columns(); ++column)
            found.push_back(read.at(row, column));
    return found;
}

void check_refused(const gltf_file& file, const std::string& part) {
    expect_error<scene_error>(part, [&] { numbers(file, 2); });
}

}

TEST_CASE("glTF accessors: each component type, as it is and normalised") {
    gltf_file file;
    file.add<std::int8_t>(gltf_int8, "SCALAR", {-128, 127});
    file.add<std::uint8_t>(gltf_uint8, "SCALAR", {0, 255});
    file.add<std::int16_t>(gltf_int16, "SCALAR", {-32768, 32767});
    file.add<std::uint16_t>(gltf_uint16, "SCALAR", {0, 65535});
    file.add<std::uint32_t>(gltf_uint32, "SCALAR", {0, 4294967295});
    file.add<float>(gltf_float, "SCALAR", {-0.25f, 1e30f});
    const std::vector<double> as_it_is[] = {
        {-128, 127}, {0, 255}, {-32768, 32767}, {0, 65535}, {0, 4294967295}};
    for (std::size_t i = 0; i < 5; ++i) {
        CAPTURE(i);
        CHECK(numbers(file, 2 + i) == as_it_is[i]);
        file.json["accessors"][2 + i]["normalized"] = true;
        CHECK(numbers(file, 2 + i) == std::vector<double>{i == 0 || i == 2 ? -1.0 : 0.0, 1});
    }
    CHECK(numbers(file, 7) == std::vector<double>{-0.25, 1e30f});
}

TEST_CASE("glTF accessors: offsets and strides") {
    gltf_file file;
    file.add<std::uint8_t>(gltf_uint8, "VEC2", {9, 1, 2, 9, 3, 4, 9, 5, 6});
    file.json["accessors"][2].update({{"byteOffset", 1}, {"count", 3}});
    file.json["bufferViews"][2]["byteStride"] = 3;
    CHECK(numbers(file, 2) == std::vector<double>{1, 2, 3, 4, 5, 6}); // the last row needs no gap after it
    file.json["accessors"][2]["count"] = 4;
    check_refused(file, "accessors[2] ends at byte 12 of a buffer view of 9");
    file.json["accessors"][2].update({{"byteOffset", 10}, {"count", 0}});
    check_refused(file, "accessors[2] ends at byte 10 of a buffer view of 9");
    file.json["accessors"][2].update({{"byteOffset", 0}, {"count", std::uint64_t{1} << 53}});
    check_refused(file, "accessors[2] ends at byte");
    file.json["bufferViews"][2]["byteStride"] = 300;
    check_refused(file, "bufferViews[2].byteStride is 300");
    file.json["accessors"][2]["count"] = std::uint64_t{1} << 54;
    check_refused(file, "accessors[2].count must be a whole number");
}

TEST_CASE("glTF accessors: sparse ones replace rows, of data or of zeros") {
    gltf_file file;
    file.add<float>(gltf_float, "SCALAR", {1, 2, 3, 4});
    file.add<std::uint8_t>(gltf_uint8, "SCALAR", {1, 3});
    file.add<float>(gltf_float, "SCALAR", {20, 40});
    file.json["accessors"][2]["sparse"] = {{"count", 2},
                                           {"indices", {{"bufferView", 3}, {"componentType", gltf_uint8}}},
                                           {"values", {{"bufferView", 4}}}};
    CHECK(numbers(file, 2) == std::vector<double>{1, 20, 3, 40});
    file.json["accessors"][2].erase("bufferView");
    CHECK(numbers(file, 2) == std::vector<double>{0, 20, 0, 40});
    SUBCASE("too short") {
        file.json["accessors"][2]["sparse"]["count"] = 3;
        check_refused(file, "accessors[2].sparse.indices ends at byte 3 of a buffer view of 2");
    }
    SUBCASE("not below the count") {
        file.json["accessors"][2]["count"] = 3;
        check_refused(file, "accessors[2].sparse must have ascending indices below its count");
    }
    SUBCASE("not ascending") {
        file.data[file.data.size() - 12] = 3;
        check_refused(file, "accessors[2].sparse must have ascending indices");
    }
}

TEST_CASE("glTF accessors: references") {
    const gltf_file file;
    expect_error<scene_error>("this is 2, and there are only 2", [&] { numbers(file, 2); });
}
