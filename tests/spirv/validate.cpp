// SPDX-License-Identifier: MIT
#include <crease/spirv.hpp>

#include "little_effect.hpp"
#include "sentence.hpp"

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("what compile gives is valid for every version") {
    for (const spirv::words& module : {spirv::compile(little::scale), spirv::compile_vertex(little::spread)})
        for (auto version :
             {spirv::vulkan_version::v1_1, spirv::vulkan_version::v1_2, spirv::vulkan_version::v1_3})
            CHECK_NOTHROW(spirv::validate(module, version));
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
