// SPDX-License-Identifier: MIT
#pragma once

#include <crease/vulkan/constant_values.hpp>
#include <crease/vulkan/effect_resources.hpp>
#include <crease/vulkan/geometry.hpp>
#include <crease/vulkan/prepared_pass.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace crease::vulkan::detail {

/// The passes of an effect, ready to be recorded one after the other.
class schedule {
public:
    /// @param resources  must outlive this
    /// @param shaders    one for each pass; empty: compile them
    /// @throws error         where shaders are not as many as passes, the device lacks a limit, or a pass
    /// reads
    ///                       and writes one image
    /// @throws spirv::error  where a pass does not compile
    schedule(device& on, effect_resources& resources, const constant_values& constants,
             const std::vector<pass_shaders>& shaders)
        : device_(on), resources_(resources), constants_(constants), sampler_(make_nearest_sampler(on)),
          shaders_(shaders), passes_(all().size()), geometry_(all().size()) {
        if (!shaders.empty() && shaders.size() != all().size())
            throw error("the effect has " + std::to_string(all().size()) + " passes, but shaders for " +
                        std::to_string(shaders.size()) + " were given");
        for (std::size_t i = 0; i < all().size(); ++i) {
            const pass& each = all()[i];
            if (!shaders.empty())
                expect_whole(each, shaders[i]);
            if (each.stage == stage_kind::geometry || !has_its_level(each))
                continue;
            passes_[i] = std::make_unique<prepared_pass>(
                on, each, resources_.effect().resources, shaders.empty() ? compile(each) : shaders[i],
                constants_.of(each), outputs_of(each), resources_.size_of(each.size), resources_.ways());
        }
    }
    schedule(const schedule&) = delete;
    schedule& operator=(const schedule&) = delete;

    /// What a geometry pass draws, and with which shaders; of a name all, as one that runs several times
    /// stands in the schedule as often.
    /// @throws error         where there is no such pass, or the push constants are not as many as `host`
    /// says
    /// @throws spirv::error  where the host's shaders with the pass's functions do not compile
    void set_geometry(std::string_view name, const geometry_shaders& host, const mesh& triangles,
                      std::span<const std::byte> push_constants) {
        for (std::size_t i : geometry_named(name)) {
            const pass& of = all()[i];
            image* attachment =
                of.to_attachment() ? resources_.bound().images[of.bindings.back().resource] : nullptr;
            auto prepared = std::make_unique<prepared_geometry>(
                device_, of, resources_.effect().resources, attachment, resources_.size_of(of.size), host,
                shaders_of(i, host), constants_.of(of), resources_.ways());
            prepared->set(triangles, push_constants);
            geometry_[i] = std::move(prepared);
        }
        descriptors_are_old_ = true;
    }

    /// Other triangles or push constants for the shaders that a geometry pass has.
    /// @throws error  where there is no such pass, it has no shaders yet, or the push constants are not as
    ///                many
    void set_geometry(std::string_view name, const mesh& triangles,
                      std::span<const std::byte> push_constants) {
        for (std::size_t i : geometry_named(name)) {
            if (!geometry_[i])
                throw error("the geometry pass '" + std::string(name) + "' has no shaders yet");
            geometry_[i]->set(triangles, push_constants);
        }
    }

    /// @throws error  where a geometry pass draws nothing
    void expect_drawn() const {
        for (std::size_t i = 0; i < all().size(); ++i)
            if (all()[i].stage == stage_kind::geometry && !geometry_[i])
                throw error("nothing is drawn in the geometry pass '" + std::string(all()[i].name) +
                            "'; set_geometry says what is");
    }

    /// Records all passes.
    /// @param after_each  called after each pass
    template <class AfterEach>
    void record(VkCommandBuffer commands, AfterEach after_each) {
        descriptors_are_old_ = resources_.take_changes() || descriptors_are_old_;
        if (descriptors_are_old_)
            write_descriptors();
        for (std::size_t i = 0; i < all().size(); ++i) {
            if (passes_[i])
                passes_[i]->record(commands, resources_.bound(), resources_.way());
            else if (geometry_[i])
                geometry_[i]->record(commands, resources_.bound(), resources_.way());
            after_each();
        }
    }

private:
    device& device_;
    effect_resources& resources_;
    constant_values constants_;
    owned_sampler sampler_;
    std::vector<pass_shaders> shaders_;                  ///< that were given
    std::vector<std::unique_ptr<prepared_pass>> passes_; ///< null for a geometry pass and one left out
    std::vector<std::unique_ptr<prepared_geometry>> geometry_;
    bool descriptors_are_old_ = true;

    std::span<const pass> all() const { return resources_.effect().passes; }

    /// Points the passes to what is bound now.
    void write_descriptors() {
        for (std::size_t i = 0; i < all().size(); ++i)
            if (passes_[i])
                passes_[i]->set_outputs(device_, outputs_of(all()[i]), resources_.size_of(all()[i].size));
        for (std::size_t i = 0; i < all().size(); ++i)
            for (std::size_t way = 0; way < resources_.ways(); ++way)
                if (passes_[i])
                    passes_[i]->write_descriptors(resources_.bound(way), sampler_, way);
                else if (geometry_[i])
                    geometry_[i]->write_descriptors(resources_.bound(way), sampler_, way);
        descriptors_are_old_ = false;
    }

    static void expect_whole(const pass& of, const pass_shaders& given) {
        const bool is_geometry = of.stage == stage_kind::geometry;
        const bool has_vertex = !given.vertex.empty(), has_main = !given.main.empty();
        const bool whole = is_geometry ? has_main == has_vertex
                                       : has_main && has_vertex == (of.stage == stage_kind::fragment);
        if (!whole)
            throw error("the shaders given for pass '" + std::string(of.name) +
                        "' are not those that compile() makes of it: one is missing or too many");
    }

    pass_shaders shaders_of(std::size_t i, const geometry_shaders& host) const {
        const bool were_given = !shaders_.empty() && !shaders_[i].main.empty();
        const bool is_glsl = !host.vertex.empty() && !host.fragment.empty();
        const std::string name = "the geometry pass '" + std::string(all()[i].name) + "' ";
        if (were_given && (!host.vertex.empty() || !host.fragment.empty()))
            throw error(name +
                        "has SPIR-V among the options of the runner: give set_geometry no GLSL for it");
        if (!were_given && !is_glsl)
            throw error(name +
                        "has no SPIR-V among the options of the runner: give set_geometry both a vertex "
                        "and a fragment shader");
        return were_given ? shaders_[i] : compile(all()[i], host);
    }

    std::vector<std::size_t> geometry_named(std::string_view name) const {
        std::vector<std::size_t> found;
        std::string names;
        for (std::size_t i = 0; i < all().size(); ++i) {
            if (all()[i].stage != stage_kind::geometry)
                continue;
            if (all()[i].name == name)
                found.push_back(i);
            names += (names.empty() ? "'" : ", '") + std::string(all()[i].name) + "'";
        }
        if (!found.empty())
            return found;
        throw error("there is no geometry pass named '" + std::string(name) + "'; there is " +
                    (names.empty() ? "none" : names));
    }

    /// Whether the images that a pass writes are large enough to have the mip level that it writes.
    bool has_its_level(const pass& each) const {
        return std::ranges::all_of(each.bindings, [this](const binding& b) {
            const image* const bound = resources_.bound().images[b.resource]; // null: an input, given later
            return b.level == binding::all_levels || !bound || b.level < bound->levels();
        });
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
                                resources_.quoted(written.resource));
            if (!resources_.is_image(written.resource))
                continue; // a pass of any size may write a list or a counter
            expect_size(each, written.resource);
            if (each.stage == stage_kind::fragment &&
                resources_.effect().resources[written.resource].life == lifetime::history)
                throw error("pass '" + std::string(each.name) + "' draws to " +
                            resources_.quoted(written.resource) +
                            ", a history, which only a compute pass may write");
            outputs.push_back(resources_.bound().images[written.resource]);
        }
        return outputs;
    }

    void expect_size(const pass& each, std::size_t written) const {
        extent own = resources_.effect().resources[written].size;
        own.level = each.size.level;
        const VkExtent2D runs = resources_.size_of(each.size), has = resources_.size_of(own);
        const bool same = runs.width == has.width && runs.height == has.height,
                   inside = runs.width <= has.width && runs.height <= has.height;
        if (each.stage == stage_kind::fragment ? !same : !inside)
            throw error("pass '" + std::string(each.name) + "' runs at another size than that of " +
                        resources_.quoted(written) + ", which it writes");
    }
};

}
