// SPDX-License-Identifier: MIT
#include <crease/spirv.hpp>

#include "little_effect.hpp"
#include "sentence.hpp"

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("what compile gives is valid for its version and those after it") {
    for (const spirv::words& module : {spirv::compile(little::scale), spirv::compile_vertex(little::spread)})
        for (auto version :
             {spirv::vulkan_version::v1_1, spirv::vulkan_version::v1_2, spirv::vulkan_version::v1_3})
            CHECK_NOTHROW(spirv::validate(module, version));
}

TEST_CASE("a module is made for the version of Vulkan that is asked for") {
    const auto spirv_of = [](spirv::vulkan_version version) {
        const spirv::words module = spirv::compile(little::scale, version);
        CHECK_NOTHROW(spirv::validate(module, version));
        CHECK_NOTHROW(spirv::validate(spirv::optimise(module, spirv::goal::speed, version), version));
        return module[1]; // the version of SPIR-V, as its specification has it
    };
    CHECK(spirv_of(spirv::vulkan_version::v1_0) == 0x00010000);
    CHECK(spirv_of(spirv::vulkan_version::v1_1) == 0x00010300);
    CHECK(spirv_of(spirv::vulkan_version::v1_2) == 0x00010500);
    CHECK(spirv_of(spirv::vulkan_version::v1_3) == 0x00010600);
    const spirv::words newest = spirv::compile_vertex(little::spread, spirv::vulkan_version::v1_3);
    CHECK(newest[1] == 0x00010600);
    CHECK(contains(sentence_of([&] { spirv::validate(newest, spirv::vulkan_version::v1_0); }),
                   "is not valid SPIR-V for Vulkan 1.0:"));
}

TEST_CASE("a module that is not valid is named with the validator's message") {
    spirv::words module = spirv::compile(little::scale);
    module.pop_back();
    const std::string said =
        sentence_of([&] { spirv::validate(module, spirv::vulkan_version::v1_1, "pass 'scale'"); });
    CHECK(contains(said, "pass 'scale' is not valid SPIR-V for Vulkan 1.1:\n"));
    CHECK(contains(said, "Missing OpFunctionEnd"));
    CHECK(contains(sentence_of([] { spirv::validate({}); }), "is not valid SPIR-V"));
    CHECK(contains(sentence_of([] { spirv::reflect(spirv::words{1, 2, 3}); }), "cannot be read"));
    CHECK(contains(sentence_of([] { spirv::disassemble(spirv::words{1, 2, 3}); }), "cannot be disassembled"));
    CHECK(contains(sentence_of([&] { spirv::optimise(module, spirv::goal::size); }), "cannot be optimised"));
}

TEST_CASE("disassembly keeps the names") {
    CHECK(contains(spirv::disassemble(spirv::compile(little::scale)), "OpName %crease_scale_gain"));
}

TEST_CASE(
    "a function that is called from several places stays one in a small module, for drivers to inline") {
    const piece pieces[] = {little::version,
                            {"twice.glsl",
                             "layout(std430, set = 0, binding = 0) buffer numbers { float x[]; };\n"
                             "float far(float a) { return sin(a) * cos(a) + exp(a) * sqrt(a) + "
                             "sin(cos(sin(cos(sin(cos(sin(cos(exp(sqrt(exp(sqrt(a)))))))))))); }\n"
                             "float once(float a) { return a + 1.0; }\n"
                             "void main() { x[0] = once(far(x[1])); x[2] = far(x[3]); }\n"}};
    const spirv::words module = spirv::compile(pieces, spirv::shader_stage::compute);
    const auto functions_of = [](const spirv::words& of) {
        const std::string text = spirv::disassemble(of);
        CHECK(!contains(text, "DontInline"));
        std::size_t count = 0;
        for (std::size_t at = 0; (at = text.find("OpFunction ", at)) != std::string::npos; ++at)
            ++count;
        return count;
    };
    const spirv::words fast = spirv::optimise(module, spirv::goal::speed),
                       small = spirv::optimise(module, spirv::goal::size);
    CHECK_NOTHROW(spirv::validate(small));
    CHECK(functions_of(module) == 3);
    CHECK(functions_of(fast) == 1);
    CHECK(functions_of(small) == 2);
    CHECK(small.size() < fast.size());
}

TEST_CASE("a stripped module is the same without names") {
    const spirv::words module = spirv::compile(little::scale);
    const spirv::words stripped = spirv::strip(module);
    CHECK_NOTHROW(spirv::validate(stripped));
    CHECK(stripped.size() < module.size());
    CHECK(!contains(spirv::disassemble(stripped), "OpName"));
    const spirv::reflection before = spirv::reflect(module), after = spirv::reflect(stripped);
    REQUIRE(after.bindings.size() == before.bindings.size());
    for (std::size_t i = 0; i < after.bindings.size(); ++i)
        CHECK(after.bindings[i].slot == before.bindings[i].slot);
    CHECK(after.constants.size() == before.constants.size());
    CHECK(contains(sentence_of([] { spirv::strip(spirv::words{1, 2, 3}); }), "cannot be stripped"));
}

TEST_CASE("optimised modules are valid and keep constants and bindings") {
    const spirv::words module = spirv::compile(little::scale);
    const spirv::reflection before = spirv::reflect(module);
    for (auto aim : {spirv::goal::speed, spirv::goal::size}) {
        const spirv::words optimised = spirv::optimise(module, aim);
        CHECK_NOTHROW(spirv::validate(optimised));
        CHECK(optimised.size() < module.size());
        const spirv::reflection after = spirv::reflect(optimised);
        CHECK(after.bindings.size() == before.bindings.size());
        REQUIRE(after.constants.size() == before.constants.size());
        for (std::size_t i = 0; i < after.constants.size(); ++i) {
            CHECK(after.constants[i].id == before.constants[i].id);
            CHECK(after.constants[i].value == before.constants[i].value);
        }
    }
}
