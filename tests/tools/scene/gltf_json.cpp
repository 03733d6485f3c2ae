// SPDX-License-Identifier: MIT
#include "scene/gltf_json.hpp"

#include "expect_error.hpp"
#include "scene/scene.hpp"

#include <nlohmann/json.hpp>

using namespace crease::tools;

TEST_CASE("glTF JSON: limits and broken text") {
    const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
    CHECK_NOTHROW(parse_gltf_json(nested(60)));
    expect_error<scene_error>("its JSON nests deeper than 64 levels", [&] { parse_gltf_json(nested(70)); });
    expect_error<scene_error>("its JSON nests deeper than 64 levels",
                              [] { parse_gltf_json(std::string(50'000'000, '[')); });
    std::string many = "[";
    for (int i = 0; i < 3'000'000; ++i)
        many += "0,";
    expect_error<scene_error>("its JSON has more than 3000000 values", [&] { parse_gltf_json(many + "0]"); });
    CHECK_NOTHROW(parse_gltf_json('"' + nested(70) + "\\\"" + nested(70) + '"')); // a text of brackets
    expect_error<scene_error>("its JSON cannot be read at byte 10",
                              [] { parse_gltf_json(R"({"a": 1, x})"); });
    expect_error<scene_error>("its JSON cannot be read", [] { parse_gltf_json(""); });
    expect_error<scene_error>("its JSON cannot be read", [] { parse_gltf_json("{\"\xff\": 1}"); });
    expect_error<scene_error>("its JSON has a number that is out of range", [] { parse_gltf_json("1e999"); });
}

TEST_CASE("glTF JSON: complaints name the place") {
    const nlohmann::json json = nlohmann::json::parse(R"({"a": [{"b": 1.5, "c": "x", "d": true}]})");
    const gltf_value root(json), item = root["a"].at(0);
    CHECK(item["b"].number() == 1.5);
    CHECK(item["c"].text() == "x");
    CHECK(item["d"].flag());
    CHECK(item.count("e") == 0);
    expect_error<scene_error>("a[0].e is missing", [&] { item["e"]; });
    expect_error<scene_error>("a[0].b must be a whole number", [&] { item["b"].whole(); });
    expect_error<scene_error>("a[0].c must be a number", [&] { item["c"].number(); });
    expect_error<scene_error>("a[0].c must be an object", [&] { item["c"].has("x"); });
    expect_error<scene_error>("a[0].d must be a text", [&] { item["d"].text(); });
    expect_error<scene_error>("a[0].b must be true or false", [&] { item["b"].flag(); });
    expect_error<scene_error>("a has 1 elements, and element 1 is asked for", [&] { root["a"].at(1); });
    const nlohmann::json list = nlohmann::json::array();
    expect_error<scene_error>("its JSON must be an object", [&] { gltf_value(list).has("a"); });
}
