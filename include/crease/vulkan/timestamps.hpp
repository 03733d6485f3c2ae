// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/device.hpp>

#include <vector>

namespace crease::vulkan::detail {

/// Timestamps that the device takes between commands.
class timestamps {
public:
    timestamps(const device& on, std::uint32_t count) : count_(count), exists_(on.has_timestamps()) {
        auto info = blank<VkQueryPoolCreateInfo>(VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO);
        info.queryType = VK_QUERY_TYPE_TIMESTAMP;
        info.queryCount = count;
        if (exists_)
            pool_ = make<owned_query_pool>(on.handle(), vkCreateQueryPool, info, "timestamps");
    }

    /// Forgets the earlier ones and takes the first.
    void begin(VkCommandBuffer commands) {
        next_ = 0;
        if (exists_)
            vkCmdResetQueryPool(commands, pool_, 0, count_);
        mark(commands);
    }

    /// Takes the next one when all commands before it are done.
    void mark(VkCommandBuffer commands) {
        if (exists_)
            vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, pool_, next_++);
    }

    /// Milliseconds between each two neighbours, once the commands are done; NaN where the device has no
    /// timestamps.
    std::vector<double> intervals(const device& on) const {
        std::vector<std::uint64_t> ticks(count_);
        if (exists_)
            check(vkGetQueryPoolResults(on.handle(), pool_, 0, count_, ticks.size() * sizeof ticks[0],
                                        ticks.data(), sizeof ticks[0],
                                        VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
                  "read timestamps");
        std::vector<double> milliseconds;
        for (std::size_t i = 1; i < ticks.size(); ++i)
            milliseconds.push_back(on.milliseconds(ticks[i - 1], ticks[i]));
        return milliseconds;
    }

private:
    std::uint32_t count_, next_ = 0;
    bool exists_;
    owned_query_pool pool_;
};

}
