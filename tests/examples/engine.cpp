// SPDX-License-Identifier: MIT
// The engine that the examples share: what it records waits for what it must wait for.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "occlusion.hpp"
#include "recorded_barriers.hpp"
#include "small_corner.hpp"

#include <map>
#include <vector>

namespace {

using ao = crease::effect<crease::directions<4, 4>, crease::single_layer, crease::hbao,
                          crease::reconstructed_normals, crease::bilateral<>>;

constexpr VkExtent2D size{small_corner::width, small_corner::height};

renderer& gpu() {
    static renderer only({.shaderStorageImageExtendedFormats = ao::features.extended_storage_formats});
    return only;
}

/// Each barrier of an image begins where the one before it ended.
void check_chains(std::size_t from) {
    std::map<VkImage, recorded_barrier> last;
    for (std::size_t i = from; i < recorded_barriers().size(); ++i) {
        const recorded_barrier& next = recorded_barriers()[i];
        if (next.image == VK_NULL_HANDLE)
            continue;
        if (const auto before = last.find(next.image); before != last.end()) {
            CHECK(next.waits_for(before->second.to, before->second.next));
            CHECK(next.before == before->second.after);
        }
        last[next.image] = next;
    }
}

}

TEST_CASE("what the engine uploads it downloads, written before the host reads it") {
    const VkExtent2D odd{7, 5};
    image& texels = gpu().make_image(odd, VK_FORMAT_R8_UNORM,
                                     VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                         VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                     VK_IMAGE_ASPECT_COLOR_BIT);
    std::vector<std::uint8_t> bytes(35);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(7 * i);
    const std::size_t before = recorded_barriers().size();
    gpu().upload(texels, std::as_bytes(std::span(bytes)));
    CHECK(gpu().download(texels) == bytes);
    REQUIRE(recorded_barriers().size() == before + 3);
    check_chains(before);
    const recorded_barrier &written = recorded_barriers()[before], &read = recorded_barriers()[before + 1],
                           &last = recorded_barriers()[before + 2];
    CHECK(written.is_waited_for_by(VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT));
    CHECK(written.after == VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    CHECK(read.is_waited_for_by(VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT));
    CHECK(read.after == VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    CHECK(last.image == VK_NULL_HANDLE);
    CHECK(last.waits_for(VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT));
    CHECK(last.is_waited_for_by(VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT));
}

TEST_CASE("each pass waits for the one before it, in every frame, and later frames are the same") {
    const std::size_t before = recorded_barriers().size();
    image& depth = gpu().make_image(size, VK_FORMAT_D32_SFLOAT,
                                    VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                    VK_IMAGE_ASPECT_DEPTH_BIT);
    const std::vector<float> texels = small_corner::device_depth();
    gpu().upload(depth, std::as_bytes(std::span(texels)));
    occlusion effect(gpu(), ao::view(), small_corner::parameters_for(ao::view()), depth);
    const auto frame = [&] {
        gpu().run([&](VkCommandBuffer commands) { effect.record(commands); });
        return gpu().download(effect.visibility());
    };
    const std::vector<std::uint8_t> first = frame();
    CHECK(std::ranges::min(first) < 204); // the corner is dark, and the open floor is not
    CHECK(std::ranges::max(first) > 250);
    CHECK(frame() == first);
    check_chains(before);
    // Twice the visibility is stored to and copied.
    const auto of_output = barriers_of(effect.visibility().handle, before);
    REQUIRE(of_output.size() == 4);
    for (std::size_t i : {0u, 2u}) {
        CHECK(
            of_output[i].is_waited_for_by(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT));
        CHECK(of_output[i + 1].is_waited_for_by(VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT));
    }
}
