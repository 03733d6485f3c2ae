// SPDX-License-Identifier: MIT
#include <crease/vulkan/buffer.hpp>

#include "sentence.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace crease;

TEST_CASE("the host sees the bytes of a buffer, as many as it was made of") {
    const vulkan::buffer buffer(validated_device(), 13, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                vulkan::transfer::from_device, "test");
    REQUIRE(buffer.bytes().size() == 13);
    std::ranges::fill(buffer.bytes(), std::byte{7});
    CHECK(std::ranges::count(buffer.bytes(), std::byte{7}) == 13);
    CHECK_NOTHROW(validated_device().check_messages());
}

TEST_CASE("too little memory: the object and its bytes are named") {
    vulkan::device device; // validation warns of such sizes first
    const std::string said = sentence_of([&] {
        vulkan::buffer(device, std::size_t{1} << 44, VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                       vulkan::transfer::to_device, "huge");
    });
    CHECK(contains(said, "the buffer 'huge' of 17592186044416 bytes"));
    CHECK(contains(said, "out of "));
}
