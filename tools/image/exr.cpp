// SPDX-License-Identifier: MIT
#include "image/file.hpp"
#include "image/image.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <fmt/format.h>

#include <span>

namespace crease::tools {
namespace {

/// The channels that make up the picture; empty where the file has none of the names.
std::vector<std::string> picture_channels(const Imf::ChannelList& channels) {
    if (channels.findChannel("R") && channels.findChannel("G") && channels.findChannel("B"))
        return {"R", "G", "B"};
    for (const char* name : {"Y", "visibility"})
        if (channels.findChannel(name))
            return {name};
    return {};
}

std::string names_of(const Imf::ChannelList& channels) {
    std::string names;
    for (auto channel = channels.begin(); channel != channels.end(); ++channel)
        names += (names.empty() ? "" : ", ") + std::string(channel.name());
    return names;
}

image read(Imf::InputFile& file, const std::string& name) {
    if (!file.isComplete())
        throw image_error(fmt::format("{}: truncated: some of its lines are missing", name));
    const Imf::ChannelList& channels = file.header().channels();
    const std::vector<std::string> wanted = picture_channels(channels);
    if (wanted.empty())
        throw image_error(fmt::format("{}: has no channels R, G and B, no Y and no visibility; it has: {}",
                                      name, names_of(channels)));
    const Imath::Box2i window = file.header().dataWindow();
    const long long width = 1LL + window.max.x - window.min.x, height = 1LL + window.max.y - window.min.y;
    if (width > longest_side || height > longest_side)
        throw image_error(
            fmt::format("{}: {} x {} texels; both must be 1 to {}", name, width, height, longest_side));
    image pixels(static_cast<unsigned>(width), static_cast<unsigned>(height),
                 static_cast<unsigned>(wanted.size()));
    const std::size_t texel = sizeof(float) * pixels.channels;
    Imf::FrameBuffer target;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const Imf::Channel& channel = channels[wanted[i]];
        if (channel.xSampling != 1 || channel.ySampling != 1)
            throw image_error(
                fmt::format("{}: channel '{}' is subsampled; save it at full resolution", name, wanted[i]));
        target.insert(wanted[i],
                      Imf::Slice::Make(Imf::FLOAT, &pixels.texels[i], window, texel, texel * pixels.width));
    }
    file.setFrameBuffer(target);
    file.readPixels(window.min.y, window.max.y);
    return pixels;
}

}

image read_exr(const std::filesystem::path& path) {
    Imf::StdISStream stream;
    stream.str(read_file(path));
    try {
        Imf::InputFile file(stream);
        return read(file, path.string());
    } catch (const image_error&) {
        throw;
    } catch (const std::exception& error) {
        throw image_error(fmt::format("{}: broken or unsupported EXR file: {}", path.string(), error.what()));
    }
}

void write_exr(const std::filesystem::path& path, std::span<const exr_channel> channels) {
    if (channels.empty())
        throw image_error(fmt::format("{}: an EXR file needs at least one channel", path.string()));
    const image& first = channels[0].source;
    Imf::StdOSStream stream;
    try {
        Imf::Header header(static_cast<int>(first.width), static_cast<int>(first.height));
        header.compression() = Imf::ZIP_COMPRESSION;
        Imf::FrameBuffer source;
        for (const exr_channel& channel : channels) {
            const image& pixels = channel.source;
            if (!pixels.same_size(first) || channel.component >= pixels.channels)
                throw image_error(
                    fmt::format("{}: channel '{}' has no such component or another size than '{}'",
                                path.string(), channel.name, channels[0].name));
            const std::size_t texel = sizeof(float) * pixels.channels;
            // The frame buffer serves reading too, so it asks for a mutable pointer that writing never writes
            // to.
            char* values =
                const_cast<char*>(reinterpret_cast<const char*>(&pixels.texels[channel.component]));
            header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
            source.insert(channel.name, Imf::Slice(Imf::FLOAT, values, texel, texel * pixels.width));
        }
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(source);
        file.writePixels(static_cast<int>(first.height));
    } catch (const image_error&) {
        throw;
    } catch (const std::exception& error) {
        throw image_error(fmt::format("{}: cannot make the EXR file: {}", path.string(), error.what()));
    }
    write_atomically(path, stream.str());
}

}
