// SPDX-License-Identifier: MIT
#include <crease/vulkan/descriptors.hpp>

#include "recorded_barriers.hpp"
#include "validated_device.hpp"

#include <doctest/doctest.h>

using namespace crease;

namespace {

using vulkan::detail::descriptor_of;
using vulkan::detail::shader_use_of;

constexpr VkPipelineStageFlags compute = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;

}

TEST_CASE("what is bound how has its kind of descriptor") {
    CHECK(descriptor_of(access::uniform, resource_kind::block) == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER);
    CHECK(descriptor_of(access::sample, resource_kind::image) == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
    for (crease::access how : {access::load, access::store, access::modify}) {
        CHECK(descriptor_of(how, resource_kind::image) == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE);
        CHECK(descriptor_of(how, resource_kind::buffer) == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    }
}

TEST_CASE("images are used as they are bound") {
    CHECK(shader_use_of(access::sample, compute).layout == VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    CHECK(shader_use_of(access::load, compute).layout == VK_IMAGE_LAYOUT_GENERAL);
    CHECK(!shader_use_of(access::load, compute).writes);
    CHECK(shader_use_of(access::store, compute).access == VK_ACCESS_SHADER_WRITE_BIT);
    CHECK(shader_use_of(access::modify, compute).access ==
          (VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT));
    CHECK((shader_use_of(access::store, compute).writes && shader_use_of(access::modify, compute).writes));
}

TEST_CASE("a program of buffers waits for what wrote any, and one without buffers does not") {
    vulkan::device& device = validated_device();
    const vulkan::buffer buffer(device, 4, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, vulkan::transfer::from_device,
                                "list");
    const vulkan::detail::bound_resources bound{{nullptr, nullptr}, {&buffer, &buffer}};
    const auto barriers_before = [&](const binding& of) {
        const std::size_t before = recorded_barriers().size();
        device.submit([&](VkCommandBuffer commands) {
            vulkan::detail::prepare_for(commands, std::span(&of, 1), bound, compute);
        });
        return barriers_of(VK_NULL_HANDLE, before);
    };
    CHECK(barriers_before({"parameters", 0, access::uniform, 0, 0}).empty());
    const auto of_list = barriers_before({"list", 1, access::load, 0, 0});
    REQUIRE(of_list.size() == 1);
    CHECK(
        of_list[0].waits_for(compute | VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT,
                             VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT));
    CHECK(of_list[0].is_waited_for_by(compute, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT));
    CHECK_NOTHROW(device.check_messages());
}
