// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/schedule.hpp>
#include <crease/vulkan/timestamps.hpp>

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace crease::vulkan {

/// How an effect is run.
struct runner_options {
    unsigned guard =
        0; ///< width of the guard band around the picture, texels: of depth, normals and captured layers
    std::map<std::string, int> constants; ///< values other than the defaults, by "part.number"
    std::vector<pass_shaders> shaders;    ///< one for each pass, as compile() gives them, of a geometry pass
                                       ///< also with the host's shaders or empty; none at all: compile them
};

/// How long a pass took on the device.
struct pass_time {
    std::string pass;        ///< its name
    double milliseconds = 0; ///< with the barriers before it; NaN where the device has no timestamps
};

/// Runs any effect on a device, at one resolution. Knows nothing of what the effect computes.
class runner {
public:
    /// Makes the images, pipelines and descriptors of the effect, whose data must outlive the runner.
    /// @param width,height  of the picture in texels, > 0
    /// @throws error         where a size is 0, the device lacks a feature, format, limit or memory, the name
    ///                       of a constant is not the effect's, or a pass reads and writes one image
    /// @throws spirv::error  where a pass does not compile
    runner(device& on, const effect_view& effect, std::uint32_t width, std::uint32_t height,
           const runner_options& options = {})
        : device_(expect_able(on, effect, width, height)), constants_(effect, options.constants),
          resources_(on, effect, {width, height}, options.guard),
          schedule_(on, resources_, constants_, options.shaders),
          timestamps_(on, static_cast<std::uint32_t>(effect.passes.size()) + 1) {
        on.check_messages();
    }
    runner(const runner&) = delete;
    runner& operator=(const runner&) = delete;

    /// Fills an input, given by its resource's name, with the texels of an image of its declared size, guard
    /// band included, and format: row after row from the top, layer after layer, level after level.
    /// Real numbers suit all formats but r32_uint; there is one for each component of a texel.
    /// @throws error  where there is no such input, or the count is another
    void upload(std::string_view name, std::span<const float> numbers) {
        vulkan::upload(device_, resources_.own_input(name), numbers);
    }
    /// The same for whole numbers: of r32_uint.
    void upload(std::string_view name, std::span<const std::uint32_t> numbers) {
        vulkan::upload(device_, resources_.own_input(name), numbers);
    }
    /// The same for the bytes of texels of any format.
    void upload(std::string_view name, std::span<const std::byte> bytes) {
        vulkan::upload(device_, resources_.own_input(name), bytes);
    }

    /// Fills the first bytes of a buffer that is an input.
    /// @throws error  where there is none of that name, or it is smaller
    void upload_buffer(std::string_view name, std::span<const std::byte> bytes) {
        const std::span<std::byte> to = resources_.buffer_of(name).bytes();
        if (bytes.size() > to.size())
            throw error("the buffer '" + std::string(name) + "' takes " + std::to_string(to.size()) +
                        " bytes, not " + std::to_string(bytes.size()));
        std::ranges::copy(bytes, to.begin());
    }

    /// Reads an input from an image of the same device, or writes an output to it: one of crease's, or around
    /// one of a host's. It must outlive the runner or the next binding of the name. That of an input may have
    /// any format that samples as the declared one does and be larger; that of an output is as it is
    /// declared. What was recorded must be done before.
    /// @throws error  where there is no such input or output, or the image does not fit it
    void bind(std::string_view name, image& given) { resources_.bind(name, given); }

    /// Says what a geometry pass draws in the runs after it, and with which shaders; a pass that runs several
    /// times draws the same each time. What was recorded must be done before.
    /// @param pass       name of a geometry pass of the effect
    /// @param triangles  must outlive the runs
    /// @param push_constants  as many bytes as the shaders say
    /// @throws error         where there is no such pass, the bytes are not as many, the device lacks a
    /// limit, or
    ///                       the pass has GLSL from here and SPIR-V among the options, or neither
    /// @throws spirv::error  where the host's shaders with the pass's functions do not compile
    void set_geometry(std::string_view pass, const geometry_shaders& host, const mesh& triangles,
                      std::span<const std::byte> push_constants = {}) {
        schedule_.set_geometry(pass, host, triangles, push_constants);
        device_.check_messages();
    }

    /// Draws something else from now on with the shaders that a geometry pass has, or with other push
    /// constants.
    /// @throws error  where there is no such pass, it has no shaders yet, or the bytes are not as many
    void set_geometry(std::string_view pass, const mesh& triangles,
                      std::span<const std::byte> push_constants = {}) {
        schedule_.set_geometry(pass, triangles, push_constants);
    }

    /// Runs all passes once and waits for them.
    /// @return the time of each pass, in order
    /// @throws error  where an input was neither uploaded nor bound, a geometry pass draws nothing, or the
    ///                view is of another size than the runner
    std::vector<pass_time> run(const parameters& values) {
        expect_ready(values.view);
        device_.submit([&](VkCommandBuffer commands) {
            timestamps_.begin(commands);
            record(commands, values, [&] { timestamps_.mark(commands); });
        });
        const std::vector<double> milliseconds = timestamps_.intervals(device_);
        const std::span<const pass> passes = resources_.effect().passes;
        std::vector<pass_time> times;
        for (std::size_t i = 0; i < passes.size(); ++i)
            times.push_back({std::string(passes[i].name), milliseconds[i]});
        return times;
    }

    /// Records all passes into a command buffer of the host's, outside a render pass. It waits for nothing.
    ///
    /// The command buffer holds the parameters itself; buffers are executed once, in the order in which they
    /// were recorded, on the queue of the device. Each image is left in the layout of its last_use(); its
    /// transition() records the barrier for what the host does with it next.
    /// @throws error  as run() does
    void record(VkCommandBuffer commands, const parameters& values) {
        expect_ready(values.view);
        record(commands, values, [] {});
    }

    /// Runs all passes several times over.
    /// @return for each run the time of each pass
    std::vector<std::vector<pass_time>> run(const parameters& values, unsigned repeats) {
        std::vector<std::vector<pass_time>> times;
        for (unsigned i = 0; i < repeats; ++i)
            times.push_back(run(values));
        return times;
    }

    /// The real numbers in the image of a resource after the last run, in the order in which upload() takes
    /// them: those of bytes in [0, 1].
    /// @throws error  where there is no such image, or it holds whole numbers
    std::vector<float> download(std::string_view name) { return vulkan::download(device_, image_of(name)); }

    /// The whole numbers in the image of a resource.
    /// @throws error  where there is no such image, or it does not hold r32_uint
    std::vector<std::uint32_t> download_uint(std::string_view name) {
        return vulkan::download_uint(device_, image_of(name));
    }

    /// The bytes of a buffer, e.g. of a report.
    /// @throws error  where there is none of that name
    std::vector<std::byte> download_buffer(std::string_view name) const {
        const std::span<const std::byte> bytes = resources_.buffer_of(name).bytes();
        return {bytes.begin(), bytes.end()};
    }

    /// The image of a resource, e.g. to bind it to another runner. The two of a history change places when
    /// a run begins.
    /// @throws error  where there is none of that name, or it is an input not given yet
    image& image_of(std::string_view name) { return resources_.image_of(name); }

private:
    device& device_;
    detail::constant_values constants_;
    detail::effect_resources resources_;
    detail::schedule schedule_;
    detail::timestamps timestamps_;

    static device& expect_able(device& on, const effect_view& effect, std::uint32_t width,
                               std::uint32_t height) {
        if (width == 0 || height == 0)
            throw error("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                        " texels cannot be rendered");
        on.require(effect.features);
        return on;
    }

    template <class AfterEach>
    void record(VkCommandBuffer commands, const parameters& values, AfterEach after_each) {
        resources_.begin_frame();
        resources_.write_block(commands, values);
        resources_.clear(commands);
        schedule_.record(commands, after_each);
        resources_.hand_to_host(commands);
    }

    void expect_ready(const view_parameters& view) const {
        resources_.expect_inputs();
        schedule_.expect_drawn();
        expect_view(view);
    }

    /// A view that was never set, or is of another size, would give a picture that is wrong and looks whole.
    void expect_view(const view_parameters& view) const {
        const bool is_read = std::ranges::any_of(resources_.effect().passes, [](const pass& each) {
            return std::ranges::any_of(each.bindings,
                                       [](const binding& b) { return b.how == access::uniform; });
        });
        const auto [width, height] = resources_.picture();
        const unsigned guard = resources_.guard();
        const auto size = [](float texels) { return std::to_string(static_cast<long>(texels)); };
        if (is_read &&
            (view.resolution[0] != static_cast<float>(width) ||
             view.resolution[1] != static_cast<float>(height) || view.guard != static_cast<float>(guard)))
            throw error("the view is of " + size(view.resolution[0]) + " x " + size(view.resolution[1]) +
                        " texels with a guard band of " + size(view.guard) + ", the runner of " +
                        std::to_string(width) + " x " + std::to_string(height) + " with " +
                        std::to_string(guard) + "; set_projection fills it");
    }
};

}
