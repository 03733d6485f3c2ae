// SPDX-License-Identifier: MIT
#include <crease/vulkan/pipeline.hpp>

#include <doctest/doctest.h>

#include <cstring>

using namespace crease;

TEST_CASE("specialization constants keep their ids, each with its own value") {
    constexpr constant constants[] = {
        {"compute", "width", 0, 8}, {"compute", "height", 1, 4}, {"scale", "gain", 7, 2}};
    constexpr std::int32_t values[] = {3, 5, -9};
    const vulkan::detail::specialization given(constants, values);
    const VkSpecializationInfo info = given.info();
    REQUIRE(info.mapEntryCount == 3);
    CHECK(info.dataSize == sizeof values);
    for (std::size_t i = 0; i < 3; ++i) {
        const VkSpecializationMapEntry& entry = info.pMapEntries[i];
        CHECK(entry.constantID == constants[i].id);
        REQUIRE(entry.size == sizeof values[0]);
        std::int32_t value;
        std::memcpy(&value, static_cast<const std::byte*>(info.pData) + entry.offset, sizeof value);
        CHECK(value == values[i]);
    }
}
