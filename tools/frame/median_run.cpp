// SPDX-License-Identifier: MIT
#include "frame/median_run.hpp"

#include "measure/median.hpp"

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
    return median(times);
}

}
