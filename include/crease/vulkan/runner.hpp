// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/copy.hpp>
#include <crease/vulkan/geometry.hpp>
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
        0; ///< width of the guard band around the picture, texels: of depth, normals and captured layers
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
    /// @throws error         where a size is 0, the device lacks a feature, format, limit or memory, the name
    ///                       of a constant is not the effect's, or a pass reads and writes one image
    /// @throws spirv::error  where a pass does not compile
    runner(device& on, const effect_view& effect, std::uint32_t width, std::uint32_t height,
           const runner_options& options = {})
        : device_(on), effect_(effect), width_(width), height_(height), guard_(options.guard),
          constants_(options.constants),
          parameters_(on, effect.block_size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, transfer::to_device,
                      "parameters"),
          timestamps_(on, static_cast<std::uint32_t>(effect.passes.size()) + 1),
          sampler_(detail::make_nearest_sampler(on)), own_(effect.resources.size()),
          own_buffers_(effect.resources.size()), passes_(effect.passes.size()),
          geometry_(effect.passes.size()) {
        if (width == 0 || height == 0)
            throw error("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                        " texels cannot be rendered");
        on.require(effect.features);
        expect_known(options.constants);
        bound_.images.resize(effect.resources.size());
        bound_.buffers.resize(effect.resources.size());
        bound_.buffers[0] = &parameters_;
        for (std::size_t i = 0; i < effect.resources.size(); ++i)
            if (is_buffer(i))
                make_buffer(i);
            else if (is_image(i) && effect.resources[i].life != lifetime::input)
                make_image(i);
        clear_history();
        fill_constants();
        prepare(options);
        on.check_messages();
    }

    /// Fills an input, given by its resource's name, with the texels of an image of its declared size, guard
    /// band included, and format: row after row from the top, layer after layer, level after level.
    /// Real numbers suit all formats but r32_uint; there is one for each component of a texel.
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

    /// Fills the first bytes of a buffer that is an input.
    /// @throws error  where there is none of that name, or it is smaller
    void upload_buffer(std::string_view name, std::span<const std::byte> bytes) {
        const std::span<std::byte> to = buffer_of(name).bytes();
        if (bytes.size() > to.size())
            throw error("the buffer '" + std::string(name) + "' takes " + std::to_string(to.size()) +
                        " bytes, not " + std::to_string(bytes.size()));
        std::ranges::copy(bytes, to.begin());
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

    /// Says what a geometry pass draws in the runs after it, and with which shaders; a pass that runs several
    /// times draws the same each time.
    /// @param pass       name of a geometry pass of the effect
    /// @param triangles  must outlive the runs
    /// @param push_constants  as many bytes as the shaders say
    /// @throws error         where there is no such pass, the bytes are not as many, or the device lacks a
    ///                       limit
    /// @throws spirv::error  where the host's shaders with the pass's functions do not compile
    void set_geometry(std::string_view pass, const geometry_shaders& host, const mesh& triangles,
                      std::span<const std::byte> push_constants = {}) {
        for (std::size_t i : geometry_passes_of(pass)) {
            const crease::pass& of = effect_.passes[i];
            image* attachment = of.to_attachment() ? bound_.images[of.bindings.back().resource] : nullptr;
            auto prepared = std::make_unique<detail::prepared_geometry>(
                device_, of, effect_.resources, attachment, size_of(of.size), host, values_of(of));
            prepared->set(triangles, push_constants);
            geometry_[i] = std::move(prepared);
        }
        descriptors_are_old_ = true;
        device_.check_messages();
    }

    /// Draws something else with the shaders that a geometry pass has, or with other push constants.
    /// @throws error  where there is no such pass, it has no shaders yet, or the bytes are not as many
    void set_geometry(std::string_view pass, const mesh& triangles,
                      std::span<const std::byte> push_constants = {}) {
        for (std::size_t i : geometry_passes_of(pass)) {
            if (!geometry_[i])
                throw error("the geometry pass '" + std::string(pass) + "' has no shaders yet");
            geometry_[i]->set(triangles, push_constants);
        }
    }

    /// Runs all passes once and waits for them.
    /// @return the time of each pass, in order
    /// @throws error  where an input was neither uploaded nor bound, a geometry pass draws nothing, or the
    ///                view is of another size than the runner
    std::vector<pass_time> run(const parameters& values) {
        expect_ready();
        expect_view(values.view);
        if (descriptors_are_old_)
            write_descriptors();
        write_block(values, effect_.views, effect_.settings.size(), parameters_.bytes().data());
        device_.submit([this](VkCommandBuffer commands) {
            timestamps_.begin(commands);
            clear(commands, [](const resource& r) { return r.cleared; });
            for (std::size_t i = 0; i < passes_.size(); ++i) {
                if (passes_[i])
                    passes_[i]->record(commands, bound_);
                else if (geometry_[i])
                    geometry_[i]->record(commands, bound_);
                timestamps_.mark(commands);
            }
            hand_to_host(commands);
        });
        const std::vector<double> milliseconds = timestamps_.intervals(device_);
        std::vector<pass_time> times;
        for (std::size_t i = 0; i < passes_.size(); ++i)
            times.push_back({std::string(effect_.passes[i].name), milliseconds[i]});
        swap_histories();
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

    /// The bytes of a buffer, e.g. of a report.
    /// @throws error  where there is none of that name
    std::vector<std::byte> download_buffer(std::string_view name) const {
        const std::span<std::byte> bytes = buffer_of(name).bytes();
        return {bytes.begin(), bytes.end()};
    }

    /// The image of a resource, e.g. to bind it to another runner.
    /// @throws error  where there is none of that name, or it is an input not given yet
    image& image_of(std::string_view name) {
        for (std::size_t i = 0; i < bound_.images.size(); ++i)
            if (bound_.images[i] && effect_.resources[i].name == name)
                return *bound_.images[i];
        throw error("there is no image named '" + std::string(name) + "'");
    }

private:
    device& device_;
    effect_view effect_;
    std::uint32_t width_, height_, guard_;
    std::map<std::string, int> constants_; ///< other than the defaults
    buffer parameters_;
    detail::timestamps timestamps_;
    detail::owned_sampler sampler_;
    std::vector<std::unique_ptr<image>> own_; ///< by resource; null where it has none
    std::vector<std::unique_ptr<buffer>> own_buffers_;
    detail::bound_resources bound_; ///< its own, or what is bound to it
    std::vector<std::unique_ptr<detail::prepared_pass>>
        passes_; ///< null for a geometry pass and one left out
    std::vector<std::unique_ptr<detail::prepared_geometry>> geometry_;
    bool descriptors_are_old_ = true;

    bool is_image(std::size_t i) const { return effect_.resources[i].kind == resource_kind::image; }
    bool is_buffer(std::size_t i) const { return effect_.resources[i].kind == resource_kind::buffer; }
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
        for (const pass& each : effect_.passes)
            for (const binding& b : each.bindings)
                if (b.resource == i || are_history(b.resource, i))
                    usage |= each.stage == stage_kind::geometry && b.how == access::attachment
                                 ? VkImageUsageFlags{VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT}
                                 : usage_of(b.how);
        return usage;
    }

    /// Whether two resources are the pair of a history, whose images change places.
    bool are_history(std::size_t i, std::size_t j) const {
        const resource &one = effect_.resources[i], &other = effect_.resources[j];
        return one.previous_of == other.name || other.previous_of == one.name;
    }

    image& make_image(std::size_t i) {
        const resource& r = effect_.resources[i];
        own_[i] = std::make_unique<image>(device_, image_description{.name = std::string(r.name),
                                                                     .texels = r.texels,
                                                                     .width = size_of(r.size).width,
                                                                     .height = size_of(r.size).height,
                                                                     .layers = r.layers,
                                                                     .samples = r.samples,
                                                                     .levels = r.levels,
                                                                     .arrayed = r.arrayed,
                                                                     .centred = r.centred,
                                                                     .usage = usage_of(i)});
        bound_.images[i] = own_[i].get();
        return *own_[i];
    }

    void make_buffer(std::size_t i) {
        const resource& r = effect_.resources[i];
        const VkExtent2D texels = size_of(r.size);
        const std::size_t each = detail::bytes_of_element(r.element);
        if (each == 0)
            throw error("the buffer " + quoted(i) + " is of '" + std::string(r.element) +
                        "'; its elements may be uint, int, float, and their vectors of two or four");
        const std::size_t bytes = std::size_t{texels.width} * texels.height * r.layers * each;
        constexpr VkBufferUsageFlags usage =
            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
        if (bytes == 0 || bytes > device_.limits().maxStorageBufferRange)
            throw error("the device '" + device_.name() + "' cannot bind the buffer " + quoted(i) + " of " +
                        std::to_string(bytes) + " bytes");
        own_buffers_[i] =
            std::make_unique<buffer>(device_, bytes, usage, transfer::from_device, std::string(r.name));
        bound_.buffers[i] = own_buffers_[i].get();
    }

    /// Clears what is chosen, a history or what each frame begins with; multisampled images are cleared where
    /// they are drawn to.
    template <class Chosen>
    void clear(VkCommandBuffer commands, Chosen chosen) {
        for (std::size_t i = 0; i < effect_.resources.size(); ++i) {
            const resource& r = effect_.resources[i];
            if (!chosen(r))
                continue;
            if (is_buffer(i))
                vkCmdFillBuffer(commands, own_buffers_[i]->handle(), 0, VK_WHOLE_SIZE, r.clear);
            if (!is_image(i) || r.samples > 1)
                continue;
            VkClearColorValue value;
            for (std::uint32_t& component : value.uint32)
                component = r.clear;
            const VkImageSubresourceRange range = bound_.images[i]->range();
            bound_.images[i]->transition(commands, copied_to);
            vkCmdClearColorImage(commands, bound_.images[i]->handle(), copied_to.layout, &value, 1, &range);
        }
    }

    /// What the first frame reads of the frame before it.
    void clear_history() {
        device_.submit([this](VkCommandBuffer commands) {
            clear(commands, [](const resource& r) { return r.life == lifetime::history; });
        });
    }

    /// What this frame wrote is what the next reads of the frame before it.
    void swap_histories() {
        for (std::size_t i = 0; i < effect_.resources.size(); ++i) {
            const std::string_view of = effect_.resources[i].previous_of;
            for (std::size_t j = 0; !of.empty() && j < effect_.resources.size(); ++j)
                if (effect_.resources[j].name == of) {
                    std::swap(own_[i], own_[j]);
                    std::swap(bound_.images[i], bound_.images[j]);
                    std::swap(own_buffers_[i], own_buffers_[j]);
                    std::swap(bound_.buffers[i], bound_.buffers[j]);
                    descriptors_are_old_ = true;
                }
        }
    }

    /// What passes wrote to buffers is seen by the host that reads it.
    void hand_to_host(VkCommandBuffer commands) const {
        bool has_buffers = false;
        for (const std::unique_ptr<buffer>& each : own_buffers_)
            has_buffers = has_buffers || each;
        if (!has_buffers)
            return;
        auto barrier = detail::blank<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
        barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT;
        barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
        vkCmdPipelineBarrier(commands, detail::buffer_writers, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0,
                             nullptr, 0, nullptr);
    }

    void fill_constants() {
        for (std::size_t i = 0; i < effect_.resources.size(); ++i) {
            const resource& r = effect_.resources[i];
            if (!is_image(i) || r.life != lifetime::constant)
                continue;
            std::vector<std::uint32_t> texels(std::size_t{r.size.fixed_width} * r.size.fixed_height);
            r.fill(texels);
            vulkan::upload(device_, *bound_.images[i], texels);
        }
    }

    void write_descriptors() {
        for (std::size_t i = 0; i < passes_.size(); ++i)
            if (passes_[i])
                passes_[i]->write_descriptors(bound_, sampler_);
            else if (geometry_[i])
                geometry_[i]->write_descriptors(bound_, sampler_);
        descriptors_are_old_ = false;
    }

    void expect_ready() const {
        for (std::size_t i = 0; i < effect_.resources.size(); ++i)
            if (is_image(i) && !bound_.images[i])
                throw error("the input " + quoted(i) + " was neither uploaded nor bound");
        for (std::size_t i = 0; i < passes_.size(); ++i)
            if (effect_.passes[i].stage == stage_kind::geometry && !geometry_[i])
                throw error("nothing is drawn in the geometry pass '" + std::string(effect_.passes[i].name) +
                            "'; set_geometry says what is");
    }

    const buffer& buffer_of(std::string_view name) const {
        for (std::size_t i = 0; i < own_buffers_.size(); ++i)
            if (own_buffers_[i] && effect_.resources[i].name == name)
                return *own_buffers_[i];
        throw error("there is no buffer named '" + std::string(name) + "'");
    }

    /// A view that was never set, or is of another size, would give a picture that is wrong and looks whole.
    void expect_view(const view_parameters& view) const {
        const bool is_read = std::ranges::any_of(effect_.passes, [](const pass& each) {
            return std::ranges::any_of(each.bindings,
                                       [](const binding& b) { return b.how == access::uniform; });
        });
        const auto size = [](float texels) { return std::to_string(static_cast<long>(texels)); };
        if (is_read &&
            (view.resolution[0] != static_cast<float>(width_) ||
             view.resolution[1] != static_cast<float>(height_) || view.guard != static_cast<float>(guard_)))
            throw error("the view is of " + size(view.resolution[0]) + " x " + size(view.resolution[1]) +
                        " texels with a guard band of " + size(view.guard) + ", the runner of " +
                        std::to_string(width_) + " x " + std::to_string(height_) + " with " +
                        std::to_string(guard_) + "; set_projection fills it");
    }

    /// Of a name, as one that runs several times stands in the schedule as often.
    std::vector<std::size_t> geometry_passes_of(std::string_view name) const {
        std::vector<std::size_t> found;
        std::string names;
        for (std::size_t i = 0; i < effect_.passes.size(); ++i) {
            if (effect_.passes[i].stage != stage_kind::geometry)
                continue;
            if (effect_.passes[i].name == name)
                found.push_back(i);
            names += (names.empty() ? "'" : ", '") + std::string(effect_.passes[i].name) + "'";
        }
        if (!found.empty())
            return found;
        throw error("there is no geometry pass named '" + std::string(name) + "'; there is " +
                    (names.empty() ? "none" : names));
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
        if (!options.shaders.empty() && options.shaders.size() != effect_.passes.size())
            throw error("the effect has " + std::to_string(effect_.passes.size()) +
                        " passes, but shaders for " + std::to_string(options.shaders.size()) + " were given");
        for (std::size_t i = 0; i < effect_.passes.size(); ++i) {
            const pass& each = effect_.passes[i];
            if (each.stage == stage_kind::geometry || !has_its_level(each))
                continue;
            passes_[i] = std::make_unique<detail::prepared_pass>(
                device_, each, effect_.resources,
                options.shaders.empty() ? compile(each) : options.shaders[i], values_of(each),
                outputs_of(each), size_of(each.size));
        }
    }

    /// Whether the images that a pass writes are large enough to have the mip level that it writes.
    bool has_its_level(const pass& each) const {
        return std::ranges::all_of(each.bindings, [this](const binding& b) {
            return b.level == binding::all_levels || b.level < bound_.images[b.resource]->levels();
        });
    }

    /// Of a pass's constants, in their order.
    std::vector<std::int32_t> values_of(const pass& of) const {
        std::vector<std::int32_t> values;
        for (const constant& c : of.constants) {
            const auto other = constants_.find(key_of(c));
            values.push_back(other == constants_.end() ? c.value : other->second);
        }
        return values;
    }

    /// The images that a pass writes.
    std::vector<image*> outputs_of(const pass& each) const {
        std::vector<image*> outputs;
        for (const binding& written : each.bindings) {
            if (!writes(written.how))
                continue;
            for (const binding& b : each.bindings)
                if (!writes(b.how) && b.resource == written.resource &&
                    (b.level == written.level || b.level == binding::all_levels))
                    throw error("pass '" + std::string(each.name) + "' both reads and writes " +
                                quoted(written.resource));
            if (!is_image(written.resource))
                continue; // a pass of any size may write a list or a counter
            extent own = effect_.resources[written.resource].size;
            own.level = each.size.level;
            const VkExtent2D runs = size_of(each.size), has = size_of(own);
            if (runs.width > has.width || runs.height > has.height ||
                (each.stage == stage_kind::fragment &&
                 (runs.width != has.width || runs.height != has.height)))
                throw error("pass '" + std::string(each.name) + "' runs at another size than that of " +
                            quoted(written.resource) + ", which it writes");
            if (each.stage == stage_kind::fragment &&
                effect_.resources[written.resource].life == lifetime::history)
                throw error("pass '" + std::string(each.name) + "' draws to " + quoted(written.resource) +
                            ", a history, which only a compute pass may write");
            outputs.push_back(bound_.images[written.resource]);
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
        bound_.images[i] = &input;
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
        if (given.levels < wanted.levels &&
            given.levels < std::bit_width(std::max(given.width, given.height)))
            throw error(refusal + "it has " + std::to_string(given.levels) + " mip levels, not " +
                        std::to_string(wanted.levels));
        if (given.width < size_of(wanted.size).width || given.height < size_of(wanted.size).height)
            throw error(refusal + "it is only " + std::to_string(given.width) + " x " +
                        std::to_string(given.height));
    }
};

}
