// What the module has where OpenImageIO is not: JPEG, TIFF, WebP and EXR with their own libraries, with the
// pixels that OpenImageIO reads and the files that it writes.

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include <algorithm>
#include <array>
#include <vector>

#include "image/module/codec.h"

namespace glibra::module {
namespace {

class ExrFile : public Imf::OStream {
  public:
    ExrFile() : OStream("picture.exr") {}

    void write(const char from[], int count) override {
        bytes.resize(std::max(bytes.size(), at_ + static_cast<size_t>(count)));
        std::copy_n(from, count, bytes.begin() + static_cast<ptrdiff_t>(at_));
        at_ += static_cast<size_t>(count);
    }
    uint64_t tellp() override { return at_; }
    void seekp(uint64_t at) override { at_ = at; }

    std::vector<unsigned char> bytes;

  private:
    uint64_t at_ = 0;
};

float numberAt(const GlibraWriteRequest& request, size_t index) {
    if (request.type == kGlibraU8)
        return static_cast<float>(static_cast<const uint8_t*>(request.pixels)[index]) * (1.F / 255);
    if (request.type == kGlibraU16)
        return static_cast<float>(static_cast<const uint16_t*>(request.pixels)[index]) * (1.F / 65535);
    return static_cast<const float*>(request.pixels)[index];
}

/// Floats, ZIP compression.
void writeExr(const GlibraWriteRequest& request) {
    Imf::setGlobalThreadCount(0);
    const auto from = static_cast<size_t>(request.components),
               components = request.keepsAlpha != 0 ? from : 3;
    const auto width = static_cast<size_t>(request.width), height = static_cast<size_t>(request.height);
    std::vector<float> pixels(width * height * components);
    for (size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = numberAt(request, i / components * from + i % components);

    Imf::Header header(request.width, request.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.insert("capDate", Imf::StringAttribute("1970:01:01 00:00:00"));
    if (request.comment != nullptr && *request.comment != 0)
        header.insert("comments", Imf::StringAttribute(request.comment));
    Imf::FrameBuffer buffer;
    constexpr std::array<const char*, 4> kNames{"R", "G", "B", "A"};
    for (size_t c = 0; c < components; ++c) {
        header.channels().insert(kNames.at(c), Imf::Channel(Imf::FLOAT));
        buffer.insert(kNames.at(c),
                      Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data() + c),
                                 components * sizeof(float), components * width * sizeof(float)));
    }
    ExrFile stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(buffer);
        file.writePixels(request.height);
    }
    writeFile(request.path, stream.bytes);
}

constexpr std::array kCodecs{
    Codec{"jpeg", readJpeg, writeJpeg},
    Codec{"tiff", readTiff, writeTiff},
    Codec{"webp", readWebp, writeWebp},
    Codec{"openexr", readExr, writeExr},
};

constexpr Codec kNone{"", [](const GlibraReadRequest&) { throw Unknown{}; },
                      [](const GlibraWriteRequest&) { throw Unknown{}; }};

}  // namespace

const Codec& codecFor(std::string_view format) {
    const auto* const found = std::find_if(kCodecs.begin(), kCodecs.end(),
                                           [&](const Codec& each) { return each.format == format; });
    return found == kCodecs.end() ? kNone : *found;
}

}  // namespace glibra::module
