// SPDX-License-Identifier: MIT
#include "frame/frame.hpp"

#include <algorithm>
#include <memory>

namespace crease::tools {

namespace {

void upload_inputs(vulkan::runner& runner, const effect_view& effect, const gbuffer& inputs) {
    for (const resource& wanted : effect.resources) {
        if (wanted.life != lifetime::input || wanted.texels == format::none)
            continue;
        if (wanted.name == "normal") {
            std::vector<float> four;
            for (std::size_t i = 0; i < inputs.normal.texels.size(); i += 3)
                four.insert(four.end(), {inputs.normal.texels[i], inputs.normal.texels[i + 1],
                                         inputs.normal.texels[i + 2], 0.0f});
            runner.upload(wanted.name, four);
        } else {
            runner.upload(wanted.name,
                          wanted.texels == format::d32_float ? inputs.device : inputs.depth.texels);
        }
    }
}

/// For each pass the median of its times, the first run left out where there are others.
std::vector<vulkan::pass_time> medians(const std::vector<std::vector<vulkan::pass_time>>& runs) {
    std::vector<vulkan::pass_time> middle = runs.back();
    const std::size_t first = runs.size() > 1 ? 1 : 0;
    for (std::size_t p = 0; p < middle.size(); ++p) {
        std::vector<double> times;
        for (std::size_t r = first; r < runs.size(); ++r)
            times.push_back(runs[r][p].milliseconds);
        const auto half = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
        std::nth_element(times.begin(), half, times.end());
        middle[p].milliseconds = *half;
    }
    return middle;
}

}

frame run_effect(vulkan::device& device, const recipe& chosen, const gbuffer& inputs,
                 const frame_options& options) {
    parameters how = settle(chosen, options);
    const auto composed = std::make_unique<composition>(chosen);
    const effect_view effect = composed->view();
    if (effect.passes.back().stage == stage_kind::functions ||
        effect.passes.back().dialect != dialect_kind::vulkan)
        throw std::runtime_error("a recipe that is run is of programs in the vulkan dialect");
    how.view = inputs.view;
    vulkan::runner runner(device, effect, inputs.depth.width, inputs.depth.height);
    upload_inputs(runner, effect, inputs);
    frame made{.visibility = image(inputs.depth.width, inputs.depth.height),
               .passes = medians(runner.run(how, options.repeats > 1 ? options.repeats + 1 : 1))};
    made.visibility.texels = runner.download("visibility");
    return made;
}

}
