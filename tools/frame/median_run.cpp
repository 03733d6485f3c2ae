// SPDX-License-Identifier: MIT
#include "frame/median_run.hpp"

#include <algorithm>

namespace crease::tools {

double median_run(vulkan::runner& runner, unsigned repeats) {
    runner.run(parameters{});
    std::vector<double> times;
    for (unsigned i = 0; i < repeats; ++i) {
        double all = 0;
        for (const vulkan::pass_time& each : runner.run(parameters{}))
            all += each.milliseconds;
        times.push_back(all);
    }
    const auto half = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), half, times.end());
    return *half;
}

}
