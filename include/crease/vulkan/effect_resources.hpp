// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/copy.hpp>
#include <crease/vulkan/descriptors.hpp>
#include <crease/vulkan/image_fit.hpp>

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace crease::vulkan::detail {

/// What a runner has on the device for the resources of an effect, at one resolution: its own images and
/// buffers, and what is bound to it.
class effect_resources {
public:
    /// Makes all but the inputs, clears the histories and fills the constants.
    /// @param picture  texels, > 0
    /// @throws error  where the device lacks a format, limit or memory
    effect_resources(device& on, const effect_view& effect, VkExtent2D picture, unsigned guard)
        : device_(on), effect_(effect), picture_(picture), guard_(guard),
          parameters_(on, effect.block_size(),
                      VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                      transfer::to_device, "parameters"),
          own_(effect.resources.size()), own_buffers_(effect.resources.size()) {
        for (bound_resources& each : bound_) {
            each.images.resize(effect.resources.size());
            each.buffers.resize(effect.resources.size());
        }
        set_buffer(0, parameters_);
        for (std::size_t i = 0; i < effect.resources.size(); ++i)
            if (is_buffer(i))
                make_buffer(i);
            else if (is_image(i) && effect.resources[i].life != lifetime::input)
                make_image(i);
        on.submit([this](VkCommandBuffer commands) {
            clear(commands, [](const resource& r) { return r.life == lifetime::history; });
        });
        fill_constants();
    }
    effect_resources(const effect_resources&) = delete;
    effect_resources& operator=(const effect_resources&) = delete;

    const effect_view& effect() const { return effect_; }
    VkExtent2D picture() const { return picture_; }
    unsigned guard() const { return guard_; }
    VkExtent2D size_of(const extent& size) const {
        return {size.width_of(picture_.width, guard_), size.height_of(picture_.height, guard_)};
    }
    bool is_image(std::size_t i) const { return effect_.resources[i].kind == resource_kind::image; }
    std::string quoted(std::size_t i) const { return "'" + std::string(effect_.resources[i].name) + "'"; }

    /// Ways round in which the pairs of histories can lie: 1 where there are none.
    std::size_t ways() const { return has_history() ? 2 : 1; }
    /// The way round of the current frame.
    std::size_t way() const { return way_; }
    /// What each resource is, one way round.
    const bound_resources& bound(std::size_t way) const { return bound_[way]; }
    const bound_resources& bound() const { return bound_[way_]; }
    /// Whether what is bound has changed since the last call.
    bool take_changes() { return std::exchange(changed_, false); }

    /// What the last frame wrote to histories is what the next reads of the frame before it.
    void begin_frame() { way_ = (way_ + 1) % ways(); }

    /// Records the writing of the block of parameters, which the commands so hold themselves.
    void write_block(VkCommandBuffer commands, const parameters& values) const {
        constexpr VkPipelineStageFlags readers =
            VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;
        std::vector<std::byte> bytes(effect_.block_size());
        crease::write_block(values, effect_.views, effect_.settings.size(), bytes.data());
        memory_barrier(commands, readers, 0, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT);
        vkCmdUpdateBuffer(commands, parameters_.handle(), 0, bytes.size(), bytes.data());
        memory_barrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, readers,
                       VK_ACCESS_UNIFORM_READ_BIT);
    }

    /// Records the clears that each frame begins with.
    void clear(VkCommandBuffer commands) {
        clear(commands, [](const resource& r) { return r.cleared; });
    }

    /// Records that the host sees what passes wrote to buffers.
    void hand_to_host(VkCommandBuffer commands) const {
        const bool has_buffers =
            std::ranges::any_of(own_buffers_, [](const std::unique_ptr<buffer>& each) { return bool(each); });
        if (has_buffers)
            memory_barrier(commands, buffer_writers,
                           VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT,
                           VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
    }

    /// The runner's own image of an input, bound to it.
    /// @throws error  where there is no such input
    image& own_input(std::string_view name) {
        const std::size_t i = named({lifetime::input}, "input", name);
        if (!own_[i])
            make_image(i);
        set_image(i, *own_[i]);
        return *own_[i];
    }

    /// @throws error  where there is no such input or output, or the image does not fit it
    void bind(std::string_view name, image& given) {
        const std::size_t i = named({lifetime::input, lifetime::output}, "input or output", name);
        const resource& r = effect_.resources[i];
        expect_fit({r, size_of(r.size), usage_by_passes(effect_, i)}, given);
        set_image(i, given);
        if (own_[i].get() != &given)
            own_[i].reset();
    }

    /// @throws error  where an input was neither uploaded nor bound
    void expect_inputs() const {
        for (std::size_t i = 0; i < effect_.resources.size(); ++i)
            if (is_image(i) && !bound().images[i])
                throw error("the input " + quoted(i) + " was neither uploaded nor bound");
    }

    /// @throws error  where there is none of that name, or it is an input not given yet
    image& image_of(std::string_view name) const {
        for (std::size_t i = 0; i < effect_.resources.size(); ++i)
            if (bound().images[i] && effect_.resources[i].name == name)
                return *bound().images[i];
        throw error("there is no image named '" + std::string(name) + "'");
    }

    /// @throws error  where there is none of that name
    const buffer& buffer_of(std::string_view name) const {
        for (std::size_t i = 0; i < effect_.resources.size(); ++i)
            if (is_buffer(i) && effect_.resources[i].name == name)
                return *bound().buffers[i];
        throw error("there is no buffer named '" + std::string(name) + "'");
    }

private:
    device& device_;
    effect_view effect_;
    VkExtent2D picture_;
    unsigned guard_;
    buffer parameters_;
    std::vector<std::unique_ptr<image>> own_; ///< by resource; null where it has none
    std::vector<std::unique_ptr<buffer>> own_buffers_;
    bound_resources bound_[2]; ///< by way round
    std::size_t way_ = 0;
    bool changed_ = true;

    bool is_buffer(std::size_t i) const { return effect_.resources[i].kind == resource_kind::buffer; }

    bool has_history() const {
        return std::ranges::any_of(effect_.resources,
                                   [](const resource& r) { return !r.previous_of.empty(); });
    }

    /// What stands for resource i the other way round.
    std::size_t other_of(std::size_t i) const {
        for (std::size_t j = 0; j < effect_.resources.size(); ++j)
            if (are_history(effect_.resources[i], effect_.resources[j]))
                return j;
        return i;
    }

    void set_image(std::size_t i, image& to) {
        changed_ = changed_ || bound_[0].images[i] != &to;
        bound_[0].images[i] = bound_[1].images[other_of(i)] = &to;
    }
    void set_buffer(std::size_t i, const buffer& to) {
        bound_[0].buffers[i] = bound_[1].buffers[other_of(i)] = &to;
    }

    void make_image(std::size_t i) {
        const resource& r = effect_.resources[i];
        VkImageUsageFlags usage = usage_by_passes(effect_, i);
        if (r.samples == 1)
            usage |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
        if (r.life == lifetime::output) // another runner may bind it
            usage |= VK_IMAGE_USAGE_SAMPLED_BIT;
        own_[i] = std::make_unique<image>(device_, image_description{.name = std::string(r.name),
                                                                     .texels = r.texels,
                                                                     .width = size_of(r.size).width,
                                                                     .height = size_of(r.size).height,
                                                                     .layers = r.layers,
                                                                     .samples = r.samples,
                                                                     .levels = r.levels,
                                                                     .arrayed = r.arrayed,
                                                                     .centred = r.centred,
                                                                     .usage = usage});
        set_image(i, *own_[i]);
    }

    void make_buffer(std::size_t i) {
        const resource& r = effect_.resources[i];
        const VkExtent2D texels = size_of(r.size);
        const std::size_t each = bytes_of_element(r.element);
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
        set_buffer(i, *own_buffers_[i]);
    }

    /// Clears what is chosen; multisampled images are cleared where they are drawn to.
    template <class Chosen>
    void clear(VkCommandBuffer commands, Chosen chosen) {
        for (std::size_t i = 0; i < effect_.resources.size(); ++i) {
            const resource& r = effect_.resources[i];
            if (!chosen(r))
                continue;
            if (is_buffer(i))
                vkCmdFillBuffer(commands, bound().buffers[i]->handle(), 0, VK_WHOLE_SIZE, r.clear);
            if (!is_image(i) || r.samples > 1)
                continue;
            VkClearColorValue value;
            for (std::uint32_t& component : value.uint32)
                component = r.clear;
            image& cleared = *bound().images[i];
            const VkImageSubresourceRange range = cleared.range();
            cleared.transition(commands, copied_to);
            vkCmdClearColorImage(commands, cleared.handle(), copied_to.layout, &value, 1, &range);
        }
    }

    void fill_constants() {
        for (std::size_t i = 0; i < effect_.resources.size(); ++i) {
            const resource& r = effect_.resources[i];
            if (!is_image(i) || r.life != lifetime::constant)
                continue;
            std::vector<std::uint32_t> texels(std::size_t{r.size.fixed_width} * r.size.fixed_height);
            r.fill(texels);
            vulkan::upload(device_, *own_[i], texels);
        }
    }

    /// The image of a name that lives in one of these ways.
    std::size_t named(std::initializer_list<lifetime> lives, const std::string& kind,
                      std::string_view name) const {
        std::string names;
        for (std::size_t i = 0; i < effect_.resources.size(); ++i) {
            if (!is_image(i) || std::ranges::find(lives, effect_.resources[i].life) == lives.end())
                continue;
            if (effect_.resources[i].name == name)
                return i;
            names += (names.empty() ? "" : ", ") + quoted(i);
        }
        throw error("there is no " + kind + " named '" + std::string(name) + "'; there is " +
                    (names.empty() ? "none" : names));
    }
};

}
