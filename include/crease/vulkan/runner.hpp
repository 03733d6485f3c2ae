// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/copy.hpp>
#include <crease/vulkan/prepared_pass.hpp>
#include <crease/vulkan/timestamps.hpp>

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace crease::vulkan {

struct runner_options {
    unsigned guard =
        0; ///< width of the guard band around the picture, texels: of depth, normals and captures
    std::map<std::string, int> constants; ///< values other than the defaults, by "part.number"
    std::vector<pass_shaders> shaders;    ///< one for each pass, as compile() gives them; empty: compile them
};

/// How long a pass took on the device.
struct pass_time {
    std::string pass;
    double milliseconds = 0; ///< with the barriers before it; NaN where the device has no timestamps
};

/// Runs any effect on a device, at one resolution. Knows nothing of what the effect computes.
class runner {
public:
    /// Makes the images, pipelines and descriptors of the effect, whose data must outlive the runner.
    /// @param width,height  of the picture in texels, > 0
    /// @throws error         where a size is 0, the device lacks a feature, format, limit or memory, a
    /// constant's
    ///                       name is not the effect's, or a pass reads and writes one image
    /// @throws spirv::error  where a pass does not compile
    runner(device& on, const effect_view& effect, std::uint32_t width, std::uint32_t height,
           const runner_options& options = {})
        : device_(on), effect_(effect), width_(width), height_(height), guard_(options.guard),
          parameters_(on, sizeof(parameters), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, transfer::to_device,
                      "parameters"),
          timestamps_(on, static_cast<std::uint32_t>(effect.passes.size()) + 1),
          sampler_(detail::make_nearest_sampler(on)), own_(effect.resources.size()),
          current_(effect.resources.size()) {
        if (width == 0 || height == 0)
            throw error("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                        " texels cannot be rendered");
        on.require(effect.features);
        expect_known(options.constants);
        for (std::size_t i = 0; i < effect.resources.size(); ++i)
            if (is_image(i) && effect.resources[i].life != lifetime::input)
                make_image(i);
        clear_history();
        fill_constants();
        prepare(options);
        on.check_messages();
    }

    /// Fills an input, given by its resource's name, with the texels of an image of its declared size, guard
    /// band included, and format: row after row from the top, layer after layer. Real numbers suit all
    /// formats but r32_uint; there is one for each component of a texel.
    /// @throws error  where there is no such input, or the count is another
    void upload(std::string_view name, std::span<const float> numbers) {
        vulkan::upload(device_, own_input(name), numbers);
    }
    void upload(std::string_view name, std::span<const std::uint32_t> numbers) {
        vulkan::upload(device_, own_input(name), numbers);
    }
    void upload(std::string_view name, std::span<const std::byte> bytes) {
        vulkan::upload(device_, own_input(name), bytes);
    }

    /// Reads an input from an image of the same device, which must outlive the runner or the next binding of
    /// the name. Its format may be any that samples as the declared one does, its size at least the declared
    /// one.
    /// @throws error  where there is no such input, or the image does not fit it
    void bind(std::string_view name, image& input) {
        const std::size_t i = input_of(name);
        expect_fit(effect_.resources[i], input.description());
        set_input(i, input);
    }

    /// Runs all passes once and waits for them.
    /// @return the time of each pass, in order
    /// @throws error  where an input was neither uploaded nor bound, or nothing was drawn for a capture
    std::vector<pass_time> run(const parameters& values) {
        for (std::size_t i = 0; i < current_.size(); ++i)
            if (is_image(i) && !current_[i])
                throw error("the input " + quoted(i) + " was neither uploaded nor bound");
        for (const capture& each : effect_.captures)
            if (!current_[each.bindings.back().resource]->is_used())
                throw error("nothing was drawn for the capture '" + std::string(each.name) + "'");
        if (descriptors_are_old_)
            for (const detail::prepared_pass& each : passes_)
                each.write_descriptors(current_, parameters_, sampler_);
        descriptors_are_old_ = false;
        std::memcpy(parameters_.bytes().data(), &values, sizeof values);
        device_.submit([this](VkCommandBuffer commands) {
            timestamps_.begin(commands);
            for (const detail::prepared_pass& each : passes_) {
                each.record(commands, current_);
                timestamps_.mark(commands);
            }
        });
        const std::vector<double> milliseconds = timestamps_.intervals(device_);
        std::vector<pass_time> times;
        for (std::size_t i = 0; i < passes_.size(); ++i)
            times.push_back({passes_[i].name(), milliseconds[i]});
        return times;
    }

    /// Runs all passes several times over.
    /// @return for each run the time of each pass
    std::vector<std::vector<pass_time>> run(const parameters& values, unsigned repeats) {
        std::vector<std::vector<pass_time>> times;
        for (unsigned i = 0; i < repeats; ++i)
            times.push_back(run(values));
        return times;
    }

    /// The real numbers in the image of a resource, in the order in which upload() takes them: those of bytes
    /// in [0, 1].
    /// @throws error  where there is no such image, or it holds whole numbers
    std::vector<float> download(std::string_view name) { return vulkan::download(device_, image_of(name)); }

    /// The whole numbers in the image of a resource.
    /// @throws error  where there is no such image, or it does not hold r32_uint
    std::vector<std::uint32_t> download_uint(std::string_view name) {
        return vulkan::download_uint(device_, image_of(name));
    }

    /// The image of a resource, e.g. to bind it to another runner.
    /// @throws error  where there is none of that name, or it is an input not given yet
    image& image_of(std::string_view name) {
        for (std::size_t i = 0; i < current_.size(); ++i)
            if (current_[i] && effect_.resources[i].name == name)
                return *current_[i];
        throw error("there is no image named '" + std::string(name) + "'");
    }

private:
    device& device_;
    effect_view effect_;
    std::uint32_t width_, height_, guard_;
    buffer parameters_;
    detail::timestamps timestamps_;
    detail::owned_sampler sampler_;
    std::vector<std::unique_ptr<image>> own_; ///< by resource; null where it has none
    std::vector<image*> current_;             ///< by resource: its own, or that bound to it
    std::vector<detail::prepared_pass> passes_;
    bool descriptors_are_old_ = true;

    bool is_image(std::size_t i) const { return effect_.resources[i].texels != format::none; }
    std::string quoted(std::size_t i) const { return "'" + std::string(effect_.resources[i].name) + "'"; }

    VkExtent2D size_of(const extent& size) const {
        return {size.width_of(width_, guard_), size.height_of(height_, guard_)};
    }

    static constexpr VkImageUsageFlags usage_of(access how) {
        return how == access::sample       ? VK_IMAGE_USAGE_SAMPLED_BIT
               : how == access::attachment ? VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT
                                           : VK_IMAGE_USAGE_STORAGE_BIT;
    }

    VkImageUsageFlags usage_of(std::size_t i) const {
        const bool multisampled = effect_.resources[i].samples > 1;
        VkImageUsageFlags usage =
            multisampled ? 0u : VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
        if (effect_.resources[i].life == lifetime::output) // another runner may bind it
            usage |= VK_IMAGE_USAGE_SAMPLED_BIT;
        for (const capture& each : effect_.captures)
            for (const binding& b : each.bindings)
                if (b.resource == i)
                    usage |= b.how == access::attachment
                                 ? VkImageUsageFlags{VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT}
                                 : usage_of(b.how);
        for (const pass& each : effect_.passes)
            for (const binding& b : each.bindings)
                if (b.resource == i)
                    usage |= usage_of(b.how);
        return usage;
    }

    image& make_image(std::size_t i) {
        const resource& r = effect_.resources[i];
        own_[i] = std::make_unique<image>(device_, image_description{.name = std::string(r.name),
                                                                     .texels = r.texels,
                                                                     .width = size_of(r.size).width,
                                                                     .height = size_of(r.size).height,
                                                                     .layers = r.layers,
                                                                     .samples = r.samples,
                                                                     .arrayed = r.arrayed,
                                                                     .centred = r.centred,
                                                                     .usage = usage_of(i)});
        current_[i] = own_[i].get();
        return *own_[i];
    }

    /// What the first frame reads of the frame before it is 0.
    void clear_history() {
        device_.submit([this](VkCommandBuffer commands) {
            for (std::size_t i = 0; i < current_.size(); ++i)
                if (current_[i] && effect_.resources[i].life == lifetime::history) {
                    constexpr VkClearColorValue zero{};
                    const VkImageSubresourceRange range = current_[i]->range();
                    current_[i]->transition(commands, copied_to);
                    vkCmdClearColorImage(commands, current_[i]->handle(), copied_to.layout, &zero, 1, &range);
                }
        });
    }

    void fill_constants() {
        for (std::size_t i = 0; i < current_.size(); ++i) {
            const resource& r = effect_.resources[i];
            if (!current_[i] || r.life != lifetime::constant)
                continue;
            std::vector<std::uint32_t> texels(std::size_t{r.size.fixed_width} * r.size.fixed_height);
            r.fill(texels, r.count);
            vulkan::upload(device_, *current_[i], texels);
        }
    }

    void expect_known(const std::map<std::string, int>& wanted) const {
        std::map<std::string, int> known;
        std::string names;
        for (const pass& each : effect_.passes)
            for (const constant& c : each.constants)
                if (known.emplace(key_of(c), c.value).second)
                    names += (names.empty() ? "" : ", ") + key_of(c);
        for (const auto& [key, value] : wanted)
            if (!known.contains(key))
                throw error("the effect has no constant '" + key + "'; it has " +
                            (names.empty() ? "none" : names));
    }
    static std::string key_of(const constant& c) { return std::string(c.part) + "." + std::string(c.number); }

    void prepare(const runner_options& options) {
        const std::vector<pass_shaders> shaders =
            options.shaders.empty() ? compile(effect_) : options.shaders;
        if (shaders.size() != effect_.passes.size())
            throw error("the effect has " + std::to_string(effect_.passes.size()) +
                        " passes, but shaders for " + std::to_string(shaders.size()) + " were given");
        for (std::size_t i = 0; i < shaders.size(); ++i) {
            const pass& each = effect_.passes[i];
            std::vector<std::int32_t> values;
            for (const constant& c : each.constants) {
                const auto other = options.constants.find(key_of(c));
                values.push_back(other == options.constants.end() ? c.value : other->second);
            }
            passes_.emplace_back(device_, each, shaders[i], values, outputs_of(each), size_of(each.size));
        }
    }

    /// The images that a pass writes.
    std::vector<image*> outputs_of(const pass& each) const {
        std::vector<image*> outputs;
        for (const binding& written : each.bindings) {
            if (!writes(written.how))
                continue;
            for (const binding& b : each.bindings)
                if (!writes(b.how) && b.resource == written.resource)
                    throw error("pass '" + std::string(each.name) + "' both reads and writes " +
                                quoted(written.resource));
            const VkExtent2D runs = size_of(each.size),
                             has = size_of(effect_.resources[written.resource].size);
            if (runs.width > has.width || runs.height > has.height ||
                (each.stage == stage_kind::fragment &&
                 (runs.width != has.width || runs.height != has.height)))
                throw error("pass '" + std::string(each.name) + "' runs at another size than that of " +
                            quoted(written.resource) + ", which it writes");
            outputs.push_back(current_[written.resource]);
        }
        return outputs;
    }

    std::size_t input_of(std::string_view name) const {
        std::string names;
        for (std::size_t i = 0; i < effect_.resources.size(); ++i) {
            if (!is_image(i) || effect_.resources[i].life != lifetime::input)
                continue;
            if (effect_.resources[i].name == name)
                return i;
            names += (names.empty() ? "" : ", ") + quoted(i);
        }
        throw error("there is no input named '" + std::string(name) + "'; there is " +
                    (names.empty() ? "none" : names));
    }

    image& own_input(std::string_view name) {
        const std::size_t i = input_of(name);
        if (!own_[i])
            make_image(i);
        set_input(i, *own_[i]);
        return *own_[i];
    }

    void set_input(std::size_t i, image& input) {
        current_[i] = &input;
        descriptors_are_old_ = true;
    }

    void expect_fit(const resource& wanted, const image_description& given) const {
        const std::string refusal =
            "the image '" + given.name + "' cannot be the input '" + std::string(wanted.name) + "': ";
        if (!(given.usage & VK_IMAGE_USAGE_SAMPLED_BIT))
            throw error(refusal + "it was not made for sampling");
        if (facts_of(given.texels).whole_numbers != facts_of(wanted.texels).whole_numbers)
            throw error(refusal + "it holds " + detail::texel_of(given.texels).name);
        if (given.layers != wanted.layers || given.arrayed != wanted.arrayed ||
            given.samples != wanted.samples)
            throw error(refusal + "it has " + std::to_string(given.layers) + " layers and " +
                        std::to_string(given.samples) + " samples a texel");
        if (given.width < size_of(wanted.size).width || given.height < size_of(wanted.size).height)
            throw error(refusal + "it is only " + std::to_string(given.width) + " x " +
                        std::to_string(given.height));
    }
};

}
