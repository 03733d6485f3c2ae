// SPDX-License-Identifier: MIT
#include <crease/vulkan/device.hpp>

#include "environment.hpp"
#include "sentence.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

using namespace crease;

TEST_CASE("a device that is not there: the sentence lists those that are") {
    const std::string said = sentence_of([] { vulkan::device({.name = "Voodoo 2"}); });
    CHECK(contains(said, "there is no Vulkan device named 'Voodoo 2'; there is '"));
    CHECK(contains(said, validated_device().name()));
}

TEST_CASE("no driver") {
    const environment nowhere("VK_DRIVER_FILES", "/nowhere.json");
    CHECK(contains(sentence_of([] { vulkan::device(); }), "there is no Vulkan 1.1"));
}

TEST_CASE("a discrete GPU comes before an integrated one, and that before software") {
    using vulkan::detail::rank_of;
    CHECK(rank_of(VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU) < rank_of(VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU));
    CHECK(rank_of(VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU) == rank_of(VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU));
    CHECK(rank_of(VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU) < rank_of(VK_PHYSICAL_DEVICE_TYPE_CPU));
}
