// Every format that OpenImageIO knows.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "image/module/codec.h"
#include "system/memory.h"

namespace glibra::module {
namespace {

OIIO::TypeDesc typeOf(int type) {
    return type == kGlibraU8 ? OIIO::TypeUInt8 : type == kGlibraU16 ? OIIO::TypeUInt16 : OIIO::TypeFloat;
}

/// The component type that holds the values of a file without loss: bytes, 16 bits, and float for everything
/// else.
int typeFor(const OIIO::ImageSpec& spec) {
    if (!spec.channelformats.empty()) return kGlibraF32;
    if (spec.format == OIIO::TypeUInt8) return kGlibraU8;
    if (spec.format == OIIO::TypeUInt16) return kGlibraU16;
    return kGlibraF32;
}

/// Index of a channel by name, or -1. ImageSpec::channelindex ends the process if a reader gave fewer names
/// than channels.
int channelNamed(const OIIO::ImageSpec& spec, const char* name) {
    const auto& names = spec.channelnames;
    const auto found = std::find(names.begin(), names.end(), name);
    const auto index = static_cast<int>(found - names.begin());
    return found != names.end() && index < spec.nchannels ? index : -1;
}

/// The channel of the file for each of red, green, blue and alpha; -1: none, so the component is 1.
std::array<int, 4> channelsOf(const OIIO::ImageSpec& spec) {
    const int red = channelNamed(spec, "R"), green = channelNamed(spec, "G"), blue = channelNamed(spec, "B");
    int alpha = channelNamed(spec, "A");
    if (alpha < 0 && spec.alpha_channel < spec.nchannels) alpha = spec.alpha_channel;
    if (red >= 0 && green >= 0 && blue >= 0) return {red, green, blue, alpha};
    const int grey = channelNamed(spec, "Y");
    if (grey >= 0) return {grey, grey, grey, alpha};
    if (spec.nchannels >= 3 && alpha != 0 && alpha != 1 && alpha != 2) return {0, 1, 2, alpha};
    const int first = alpha == 0 && spec.nchannels > 1 ? 1 : 0;
    return {first, first, first, alpha == first ? -1 : alpha};
}

template <class Value>
void fill(void* pixels, size_t count, int component, Value value) {
    auto* at = static_cast<Value*>(pixels) + component;
    for (size_t i = 0; i < count; ++i) at[4 * i] = value;
}

/// True for whole numbers that are no fractions of their range: those with a sign.
bool isWhole(const OIIO::TypeDesc& format) {
    return format == OIIO::TypeInt8 || format == OIIO::TypeInt16 || format == OIIO::TypeInt32;
}

/// The largest number of a format of whole numbers, which OpenImageIO reads as 1.
float largestOf(const OIIO::ImageSpec& spec) {
    const auto bits = static_cast<int>(8 * spec.format.size()) - 1;
    return std::ldexp(1.F, bits) - (bits < 24 ? 1.F : 0.F);
}

void fillAlpha(void* pixels, size_t count, int type) {
    if (type == kGlibraU8) fill<uint8_t>(pixels, count, 3, 255);
    if (type == kGlibraU16) fill<uint16_t>(pixels, count, 3, 65535);
    if (type == kGlibraF32) fill<float>(pixels, count, 3, 1.F);
}

/// Component `component` of the pixels comes from channel `channel` of the file; or several adjacent ones of
/// both.
void readRun(OIIO::ImageInput& input, int channel, int count, int type, void* pixels, size_t component) {
    const OIIO::TypeDesc format = typeOf(type);
    void* to = static_cast<char*>(pixels) + component * format.size();
    if (!input.read_image(0, 0, channel, channel + count, format, to,
                          4 * static_cast<OIIO::stride_t>(format.size())))
        throw Failure{input.geterror()};
}

/// Moves the channels from `first`, which are adjacent in every pixel, to the places in `channels`.
template <class Value>
void arrange(void* pixels, size_t count, const std::array<int, 4>& channels, int first) {
    auto* at = static_cast<Value*>(pixels);
    for (size_t i = 0; i < count; ++i, at += 4) {
        const std::array<Value, 4> read{at[0], at[1], at[2], at[3]};
        for (size_t c = 0; c < 4; ++c)
            if (channels[c] >= 0) at[c] = read[static_cast<size_t>(channels[c] - first)];
    }
}

/// Reads all channels at once if possible: most formats decode the whole picture at every call, and some
/// cannot restart when they read from memory.
void readChannels(OIIO::ImageInput& input, size_t count, const std::array<int, 4>& channels, int type,
                  void* pixels) {
    int first = channels[0], last = channels[0];
    for (const int each : channels) {
        if (each < 0) continue;
        first = std::min(first, each);
        last = std::max(last, each);
    }
    if (last - first < 4) {
        readRun(input, first, last - first + 1, type, pixels, 0);
        if (type == kGlibraU8) arrange<uint8_t>(pixels, count, channels, first);
        if (type == kGlibraU16) arrange<uint16_t>(pixels, count, channels, first);
        if (type == kGlibraF32) arrange<float>(pixels, count, channels, first);
    } else {
        for (size_t c = 0; c < 4; ++c)
            if (channels[c] >= 0) readRun(input, channels[c], 1, type, pixels, c);
    }
    // Some readers return the readable part of a short file and leave an error message.
    if (input.has_error()) throw Failure{input.geterror()};
}

/// The content of the file. Every format is encoded in memory: not every writer of OpenImageIO notices that a
/// disk is full.
std::vector<unsigned char> encoded(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec,
                                   const GlibraWriteRequest& request) {
    const auto write = [&](const std::string& path) {
        const OIIO::TypeDesc type = typeOf(request.type);
        const auto stride = static_cast<OIIO::stride_t>(type.size()) * request.components;
        if (!output.open(path, spec) || !output.write_image(type, request.pixels, stride) || !output.close())
            throw Failure{output.geterror()};
    };
    OIIO::Filesystem::IOVecOutput memory;
    if (output.supports("ioproxy") && output.set_ioproxy(&memory)) {
        write(request.path);
        return memory.buffer();
    }
    const system::MemoryFile file(request.path);
    write(file.path());
    std::vector<unsigned char> bytes = file.content();
    // The header of SGI ends with the name of the picture and unused bytes, which OpenImageIO leaves as it
    // finds them in memory.
    constexpr size_t kSgiNameAt = 24, kSgiHeader = 512;
    if (std::strcmp(request.format, "sgi") == 0 && bytes.size() > kSgiHeader)
        std::fill(bytes.begin() + kSgiNameAt, bytes.begin() + kSgiHeader, static_cast<unsigned char>(0));
    return bytes;
}

void quieten() {
    // Pictures are small and rendering uses several processes, so OpenImageIO starts no threads.
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
}

void readByOpenImageIo(const GlibraReadRequest& request) {
    quieten();
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(request.format);
    if (!input) throw Failure{OIIO::geterror()};
    OIIO::Filesystem::IOMemReader memory(request.bytes, request.size);
    std::optional<system::MemoryFile> copy;
    std::string name = std::string("picture.") + request.format;
    if (!input->supports("ioproxy") || !input->set_ioproxy(&memory)) try {
            copy.emplace(request.path != nullptr ? request.path : "");
            copy->write({reinterpret_cast<const std::byte*>(request.bytes), request.size});
            name = copy->path();
        } catch (const std::system_error&) {
            // A confined process may be able to read the file where it may write none.
            if (request.path == nullptr) throw;
            name = request.path;
        }

    OIIO::ImageSpec wish, spec;
    wish.attribute("oiio:UnassociatedAlpha", 1);  // colours as in the file, not multiplied by alpha
    if (!input->open(name, spec, wish)) throw Failure{input->geterror()};
    if (spec.deep) throw Failure{"it is a deep picture"};
    if (spec.depth > 1) throw Failure{"it is a volume"};
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) throw Failure{"it holds no pixels"};
    constexpr int kMostChannels = 64;
    if (spec.nchannels > kMostChannels)
        throw Failure{"it has " + std::to_string(spec.nchannels) + " channels"};

    const int type = typeFor(spec);
    const std::array<int, 4> channels = channelsOf(spec);
    void* const pixels =
        allocate(request, static_cast<uint64_t>(spec.width), static_cast<uint64_t>(spec.height), type);
    const size_t count = static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height);
    readChannels(*input, count, channels, type, pixels);
    if (channels[3] < 0) fillAlpha(pixels, count, type);
    if (isWhole(spec.format) && spec.channelformats.empty()) {
        // Alpha stays a fraction.
        const float factor = largestOf(spec);
        for (size_t i = 0; i < 4 * count; ++i)
            if (i % 4 != 3) static_cast<float*>(pixels)[i] *= factor;
    }
    input->close();
}

void writeByOpenImageIo(const GlibraWriteRequest& request) {
    quieten();
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(request.format);
    if (!output) {
        OIIO::geterror();  // clears a text that names neither the file nor the reason
        throw Failure{"OpenImageIO cannot write this format"};
    }
    const int components = request.keepsAlpha != 0 && output->supports("alpha") ? request.components : 3;
    const bool floats =
        std::strcmp(request.format, "openexr") == 0 || std::strcmp(request.format, "hdr") == 0;
    OIIO::ImageSpec spec(request.width, request.height, components,
                         floats ? OIIO::TypeFloat : typeOf(request.type));
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("Compression", std::strcmp(request.format, "jpeg") == 0 ? "jpeg:95" : "zip");
    spec.attribute("jpeg:subsampling", "4:4:4");  // colours at full resolution
    // Formats that store a date get this one instead of the current time: equal pictures are equal files.
    spec.attribute("DateTime", "1970:01:01 00:00:00");
    if (request.comment != nullptr && *request.comment != 0)
        spec.attribute("ImageDescription", request.comment);
    writeFile(request.path, encoded(*output, spec, request));
}

/// What has a library of its own besides.
constexpr std::array kOwnCodecs{
    Codec{"webp", readWebp, writeWebp},
    Codec{"openexr", readExr, writeByOpenImageIo},
};
constexpr Codec kOpenImageIo{"", readByOpenImageIo, writeByOpenImageIo};

}  // namespace

const Codec& codecFor(std::string_view format) {
    const auto* const found = std::find_if(kOwnCodecs.begin(), kOwnCodecs.end(),
                                           [&](const Codec& each) { return each.format == format; });
    return found == kOwnCodecs.end() ? kOpenImageIo : *found;
}

}  // namespace glibra::module
