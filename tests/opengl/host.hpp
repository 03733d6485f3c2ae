// SPDX-License-Identifier: MIT
#pragma once

#include "context.hpp"

#include <crease/effect/effect_view.hpp>

#include <algorithm>
#include <bit>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Runs an effect for OpenGL as its description says: compute and fragment passes, at one resolution. Its
/// objects go with the context.
class opengl_host {
public:
    opengl_host(const crease::effect_view& effect, unsigned width, unsigned height)
        : effect_(effect), width_(width), height_(height) {
        make_context();
        glGenVertexArrays(1, &vertex_array_);
        glGenBuffers(1, &block_);
        glGenSamplers(1, &sampler_); // as crease::access::sample asks for
        glSamplerParameteri(sampler_, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
        glSamplerParameteri(sampler_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glSamplerParameteri(sampler_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glSamplerParameteri(sampler_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        for (const crease::resource& r : effect.resources)
            textures_.push_back(r.kind == crease::resource_kind::image ? make_texture(r) : 0);
        check_errors("making textures");
    }

    void upload_depth(const std::vector<float>& texels) {
        const std::size_t i = index_of("depth");
        glBindTexture(GL_TEXTURE_2D, textures_[i]);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_of(effect_.resources[i].size),
                        height_of(effect_.resources[i].size), GL_DEPTH_COMPONENT, GL_FLOAT, texels.data());
        check_errors("filling the depth");
    }

    void run(const crease::parameters& values) {
        glBindVertexArray(vertex_array_);
        glBindBuffer(GL_UNIFORM_BUFFER, block_);
        std::vector<std::byte> bytes(effect_.block_size());
        crease::write_block(values, effect_.views, effect_.settings.size(), bytes.data());
        glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
        for (const crease::pass& each : effect_.passes) {
            if (!has_its_level(each))
                continue;
            GLuint framebuffer; // of this pass's attachments alone
            glGenFramebuffers(1, &framebuffer);
            glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
            std::vector<GLenum> drawn_to;
            for (const crease::binding& b : each.bindings) {
                bind(b);
                if (b.how == crease::access::attachment)
                    drawn_to.push_back(GL_COLOR_ATTACHMENT0 + b.slot);
            }
            const GLuint program = link(each);
            glUseProgram(program);
            if (each.stage == crease::stage_kind::compute) {
                dispatch(each);
            } else {
                glDrawBuffers(static_cast<GLsizei>(drawn_to.size()), drawn_to.data());
                glViewport(0, 0, width_of(each.size), height_of(each.size));
                glDrawArrays(GL_TRIANGLES, 0, 3);
            }
            glMemoryBarrier(GL_ALL_BARRIER_BITS);
            glDeleteProgram(program);
            glDeleteFramebuffers(1, &framebuffer);
            check_errors("pass '" + std::string(each.name) + "'");
        }
    }

    /// @param components  of a texel, from red on
    std::vector<float> download(std::string_view name, unsigned components = 1) {
        const std::size_t i = index_of(name);
        std::vector<float> texels(std::size_t{width_} * height_ * components);
        glBindTexture(GL_TEXTURE_2D, textures_[i]);
        glGetTexImage(GL_TEXTURE_2D, 0, components == 1 ? GL_RED : GL_RGBA, GL_FLOAT, texels.data());
        check_errors("reading back '" + std::string(name) + "'");
        return texels;
    }

private:
    crease::effect_view effect_;
    unsigned width_, height_;
    std::vector<GLuint> textures_; ///< by resource; 0 for the block of parameters
    GLuint vertex_array_{}, block_{}, sampler_{};

    std::size_t index_of(std::string_view name) const {
        for (std::size_t i = 0; i < effect_.resources.size(); ++i)
            if (effect_.resources[i].name == name)
                return i;
        throw std::runtime_error("there is no image named '" + std::string(name) + "'");
    }
    GLsizei width_of(const crease::extent& size) const { return static_cast<GLsizei>(size.width_of(width_)); }
    GLsizei height_of(const crease::extent& size) const {
        return static_cast<GLsizei>(size.height_of(height_));
    }
    static GLenum target_of(const crease::resource& r) {
        return r.arrayed ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
    }

    static GLenum format_of(crease::format texels) {
        switch (texels) {
        case crease::format::r8_unorm:
            return GL_R8;
        case crease::format::rgba8_unorm:
            return GL_RGBA8;
        case crease::format::r32_uint:
            return GL_R32UI;
        case crease::format::rg32_uint:
            return GL_RG32UI;
        case crease::format::rgba32_uint:
            return GL_RGBA32UI;
        case crease::format::r32_float:
            return GL_R32F;
        case crease::format::rg32_float:
            return GL_RG32F;
        case crease::format::rgba16_float:
            return GL_RGBA16F;
        case crease::format::rgba32_float:
            return GL_RGBA32F;
        case crease::format::d32_float:
            return GL_DEPTH_COMPONENT32F;
        case crease::format::none:
            break;
        }
        throw std::runtime_error("an image has a format");
    }

    GLsizei levels_of(const crease::resource& r) const {
        const unsigned longest = std::max(r.size.width_of(width_), r.size.height_of(height_));
        return static_cast<GLsizei>(std::min(r.levels, static_cast<unsigned>(std::bit_width(longest))));
    }

    GLuint make_texture(const crease::resource& r) const {
        GLuint texture;
        glGenTextures(1, &texture);
        glBindTexture(target_of(r), texture);
        const GLsizei levels = levels_of(r);
        if (r.arrayed)
            glTexStorage3D(GL_TEXTURE_2D_ARRAY, levels, format_of(r.texels), width_of(r.size),
                           height_of(r.size), static_cast<GLsizei>(r.layers));
        else
            glTexStorage2D(GL_TEXTURE_2D, levels, format_of(r.texels), width_of(r.size), height_of(r.size));
        return texture;
    }

    static GLint first_level(const crease::binding& b) {
        return b.level == crease::binding::all_levels ? 0 : static_cast<GLint>(b.level);
    }

    /// One level of a texture, as a texture; it goes with the context.
    GLuint view_of(const crease::binding& b) const {
        const crease::resource& r = effect_.resources[b.resource];
        GLuint view;
        glGenTextures(1, &view);
        glTextureView(view, target_of(r), textures_[b.resource], format_of(r.texels), b.level, 1, 0,
                      r.layers);
        return view;
    }

    /// Whether the images that a pass touches are large enough to have its level.
    bool has_its_level(const crease::pass& of) const {
        return std::ranges::all_of(of.bindings, [this](const crease::binding& b) {
            return b.level == crease::binding::all_levels ||
                   first_level(b) < levels_of(effect_.resources[b.resource]);
        });
    }

    void bind(const crease::binding& b) const {
        const GLuint texture = textures_[b.resource];
        const crease::resource& r = effect_.resources[b.resource];
        switch (b.how) {
        case crease::access::uniform:
            glBindBufferBase(GL_UNIFORM_BUFFER, b.slot, block_);
            break;
        case crease::access::sample:
            glActiveTexture(GL_TEXTURE0 + b.slot);
            glBindTexture(target_of(r), b.level == crease::binding::all_levels ? texture : view_of(b));
            glBindSampler(b.slot, sampler_);
            break;
        case crease::access::load:
        case crease::access::store:
        case crease::access::modify:
            glBindImageTexture(b.slot, texture, first_level(b), r.arrayed, 0,
                               b.how == crease::access::load    ? GL_READ_ONLY
                               : b.how == crease::access::store ? GL_WRITE_ONLY
                                                                : GL_READ_WRITE,
                               format_of(r.texels));
            break;
        case crease::access::attachment:
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + b.slot, GL_TEXTURE_2D, texture, 0);
            break;
        case crease::access::result:
            throw std::runtime_error("functions have no output of their own");
        }
    }

    void dispatch(const crease::pass& of) const {
        const auto groups = [](GLsizei texels, unsigned group) {
            return (static_cast<GLuint>(texels) + group - 1) / group;
        };
        const bool rows = of.covers == crease::dispatch::rows,
                   columns = of.covers == crease::dispatch::columns;
        glDispatchCompute(rows ? 1 : groups(width_of(of.size), of.group_width()),
                          columns ? 1 : groups(height_of(of.size), of.group_height()), 1);
    }

    static void attach(GLuint program, GLenum stage, std::span<const crease::piece> pieces) {
        std::vector<const char*> texts; // the pieces are not NUL-terminated: OpenGL takes their lengths
        std::vector<GLint> lengths;
        for (const crease::piece& piece : pieces) {
            texts.push_back(piece.text.data());
            lengths.push_back(static_cast<GLint>(piece.text.size()));
        }
        const GLuint shader = glCreateShader(stage);
        glShaderSource(shader, static_cast<GLsizei>(texts.size()), texts.data(), lengths.data());
        glCompileShader(shader);
        GLint compiled = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
        char log[4096]{};
        glGetShaderInfoLog(shader, sizeof log, nullptr, log);
        if (!compiled)
            throw std::runtime_error(log);
        glAttachShader(program, shader);
        glDeleteShader(shader); // lives as long as the program
    }

    static GLuint link(const crease::pass& of) {
        const GLuint program = glCreateProgram();
        const bool compute = of.stage == crease::stage_kind::compute;
        attach(program, compute ? GL_COMPUTE_SHADER : GL_FRAGMENT_SHADER, of.pieces);
        if (!compute)
            attach(program, GL_VERTEX_SHADER, of.vertex_pieces);
        glLinkProgram(program);
        GLint linked = 0;
        glGetProgramiv(program, GL_LINK_STATUS, &linked);
        char log[4096]{};
        glGetProgramInfoLog(program, sizeof log, nullptr, log);
        if (!linked)
            throw std::runtime_error(log);
        return program;
    }
};
