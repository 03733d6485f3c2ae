// SPDX-License-Identifier: MIT
#include "frame/frame.hpp"

#include "measure/median.hpp"

#include <span>

namespace crease::tools {

namespace {

/// For each pass the median of its times.
std::vector<vulkan::pass_time> medians(const std::vector<frame_times>& turns,
                                       std::vector<vulkan::pass_time> frame_times::*which) {
    std::vector<vulkan::pass_time> middle = turns.front().*which;
    for (std::size_t p = 0; p < middle.size(); ++p) {
        std::vector<double> times;
        for (const frame_times& turn : turns)
            times.push_back((turn.*which)[p].milliseconds);
        middle[p].milliseconds = median(times);
    }
    return middle;
}

}

double frame_times::total() const {
    double milliseconds = 0;
    for (const std::vector<vulkan::pass_time>& all : {captures, passes})
        for (const vulkan::pass_time& t : all)
            milliseconds += t.milliseconds;
    return milliseconds;
}

std::vector<frame_times> take_turns(std::span<const std::unique_ptr<prepared_effect>> effects,
                                    unsigned repeats, const std::function<void(double)>& progress) {
    std::vector<std::vector<frame_times>> turns(effects.size());
    for (unsigned turn = 0; turn <= repeats; ++turn)
        for (std::size_t i = 0; i < effects.size(); ++i) {
            const frame_times times = effects[i]->run();
            if (turn > 0)
                turns[i].push_back(times);
            if (progress)
                progress((turn + (static_cast<double>(i) + 1) / static_cast<double>(effects.size())) /
                         (repeats + 1));
        }
    std::vector<frame_times> all;
    for (const auto& own : turns)
        all.push_back({medians(own, &frame_times::captures), medians(own, &frame_times::passes)});
    return all;
}

}
