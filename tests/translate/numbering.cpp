// SPDX-License-Identifier: MIT
// Which numbers bindings have in each language.
#include <crease/translate/numbering.hpp>

#include "spirv/little_effect.hpp"
#include "spirv/sentence.hpp"
#include "translate/declared.hpp"

#include <doctest/doctest.h>

namespace {

using namespace crease;
using translate::language;
using translate::target;
using numbers = std::map<std::string, std::string>;

numbers numbers_in(const target& to) {
    const translate::translation made = translate::shader(little::effect, little::scale, to);
    CHECK(declared_numbers(made).all == told_numbers(made));
    return declared_numbers(made).all;
}

/// What `places` of HLSL's `version` is refused with.
std::string refusal(std::map<std::string, translate::place> places, unsigned version = 50) {
    return sentence_of([&] {
        translate::shader(little::effect, little::scale,
                          {.to = language::hlsl, .version = version, .places = std::move(places)});
    });
}

}

TEST_CASE("each kind is counted from 0") {
    CHECK(numbers_in({.to = language::hlsl, .version = 50}) == numbers{{"crease_parameters", "b0"},
                                                                       {"crease_depth", "t0"},
                                                                       {"_crease_depth_sampler", "s0"},
                                                                       {"crease_output", "u0"}});
    CHECK(numbers_in({.to = language::msl, .version = 21}) == numbers{{"crease_given", "buffer 0"},
                                                                      {"crease_depth", "texture 0"},
                                                                      {"crease_depthSmplr", "sampler 0"},
                                                                      {"crease_output", "texture 1"}});
    const numbers opengl{
        {"crease_parameters", "binding 0"}, {"crease_depth", "binding 0"}, {"crease_output", "binding 0"}};
    CHECK(numbers_in({.to = language::glsl, .version = 430}) == opengl);
    CHECK(numbers_in({.to = language::glsl_es, .version = 310}) == opengl);
}

TEST_CASE("a host gives the numbers") {
    CHECK(numbers_in({.to = language::hlsl,
                      .version = 51,
                      .places = {{"depth", {.number = 7, .sampler = 2, .space = 3}},
                                 {"parameters", {.number = 4}}}}) ==
          numbers{{"crease_parameters", "b4 space0"},
                  {"crease_depth", "t7 space3"},
                  {"_crease_depth_sampler", "s2 space3"},
                  {"crease_output", "u0 space0"}});
    CHECK(numbers_in({.to = language::msl,
                      .version = 21,
                      .places = {{"output", {.number = 0}}, {"parameters", {.number = 30}}}}) ==
          numbers{{"crease_given", "buffer 30"},
                  {"crease_depth", "texture 1"},
                  {"crease_depthSmplr", "sampler 0"},
                  {"crease_output", "texture 0"}});
    CHECK(numbers_in({.to = language::glsl, .version = 430, .places = {{"depth", {.number = 5}}}}) ==
          numbers{{"crease_parameters", "binding 0"},
                  {"crease_depth", "binding 5"},
                  {"crease_output", "binding 0"}});
}

TEST_CASE("numbers that cannot be are refused") {
    CHECK(refusal({{"depht", {.number = 1}}}) ==
          "the effect has no binding 'depht'; it has depth, input, output, parameters");
    CHECK(refusal({{"depth", {.number = 1, .space = 1}}}) ==
          "pass 'scale' cannot be HLSL 5.0: 'depth' is given a register space, which HLSL has from 5.1 on");
    CHECK(refusal({{"depth", {.number = 1, .space = 1}}}, 51).empty());
    CHECK(sentence_of([] {
              translate::shader(little::effect, little::scale,
                                {.to = language::msl,
                                 .version = 21,
                                 .places = {{"depth", {.number = 3}}, {"output", {.number = 3}}}});
          }) == "pass 'scale' cannot be MSL 2.1: 'depth' and 'output' are both given texture_index 3");
}

TEST_CASE("MSL is told how long buffers are") {
    const piece pieces[] = {{"whole",
                             "#version 450\nlayout(local_size_x = 8) in;\n"
                             "layout(std430, binding = 0) buffer first_buffer { uint first[]; };\n"
                             "layout(std430, binding = 1) buffer last_buffer { uint n; uvec2 last[]; };\n"
                             "void main() { first[0] = uint(last.length()); }\n"}};
    const spirv::words module = spirv::compile(pieces, spirv::shader_stage::compute);
    pass asks;
    asks.name = "asks";
    const auto made_with = [&](std::map<std::string, translate::place> places) {
        return translate::module({}, asks, module,
                                 {.to = language::msl, .version = 21, .places = std::move(places)});
    };
    const translate::translation counted = made_with({});
    CHECK(counted.buffer_sizes == 2);
    CHECK(declared_numbers(counted).all == told_numbers(counted));
    CHECK(contains(counted.text, "= spvBufferSizeConstants[1];")); // of the last buffer, by its own number
    CHECK(contains(counted.text, "BufferSize - 8) / 8"));          // less what stands before the array
    const translate::translation given = made_with({{"buffer_sizes", {.number = 0}}});
    CHECK(given.buffer_sizes == 0);
    CHECK(declared_numbers(given).all == told_numbers(given));
    CHECK(contains(given.text, "= spvBufferSizeConstants[2];"));
    CHECK(sentence_of([&] {
              made_with({{"buffer_sizes", {.number = 5}}, {"last_buffer", {.number = 5}}});
          }) ==
          "pass 'asks' cannot be MSL 2.1: 'last_buffer' and 'buffer_sizes' are both given buffer_index 5");
    CHECK_FALSE(
        translate::shader(little::effect, little::scale, {.to = language::msl, .version = 21}).buffer_sizes);
}
