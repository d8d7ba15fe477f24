// OpenEXR.

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfThreading.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "image/module/codec.h"

namespace glibra::module {
namespace {

/// The bytes of a request as a file.
class ExrBytes : public Imf::IStream {
  public:
    explicit ExrBytes(const GlibraReadRequest& request)
        : IStream("picture.exr"), bytes_(static_cast<const char*>(request.bytes)), size_(request.size) {}

    bool read(char to[], int count) override {
        const auto wanted = static_cast<uint64_t>(std::max(count, 0));
        if (at_ > size_ || wanted > size_ - at_) throw Failure{"the file ends before its pixels"};
        std::memcpy(to, bytes_ + at_, wanted);
        at_ += wanted;
        return at_ < size_;
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t at) override { at_ = at; }

  private:
    const char* bytes_;
    uint64_t size_;
    uint64_t at_ = 0;
};

/// The pixels of a request, of the size of the display window.
class ExrCanvas {
  public:
    ExrCanvas(const GlibraReadRequest& request, const Imf::Header& header, bool hasAlpha)
        : display_(header.displayWindow()), data_(header.dataWindow()) {
        const auto width = static_cast<uint64_t>(int64_t{display_.max.x} - display_.min.x + 1),
                   height = static_cast<uint64_t>(int64_t{display_.max.y} - display_.min.y + 1);
        width_ = static_cast<size_t>(width);
        pixels_ = static_cast<float*>(allocate(request, width, height, kGlibraF32));
        for (size_t i = 0; i < width * height; ++i) {
            const std::array<float, 4> outside{0, 0, 0, hasAlpha ? 0.F : 1.F};
            std::memcpy(pixels_ + 4 * i, outside.data(), sizeof outside);
        }
    }

    /// The rows and columns that both windows have.
    [[nodiscard]] int firstRow() const { return std::max(display_.min.y, data_.min.y); }
    [[nodiscard]] int lastRow() const { return std::min(display_.max.y, data_.max.y); }
    [[nodiscard]] int firstColumn() const { return std::max(display_.min.x, data_.min.x); }
    [[nodiscard]] int lastColumn() const { return std::min(display_.max.x, data_.max.x); }

    [[nodiscard]] float* at(int x, int y) const {
        const auto column = static_cast<size_t>(int64_t{x} - display_.min.x),
                   row = static_cast<size_t>(int64_t{y} - display_.min.y);
        return pixels_ + 4 * (row * width_ + column);
    }
    [[nodiscard]] const Imath::Box2i& data() const { return data_; }

  private:
    Imath::Box2i display_, data_;
    size_t width_ = 0;
    float* pixels_ = nullptr;
};

/// The name of a channel without its layer, in small letters.
std::string lastWord(const std::string& name) {
    std::string word = name.substr(name.rfind('.') + 1);
    for (char& each : word)
        if (each >= 'A' && each <= 'Z') each = static_cast<char>(each - 'A' + 'a');
    return word;
}

/// The channels of one layer for red, green, blue and alpha; empty: the file has none.
struct ExrChannels {
    std::array<std::string, 4> names;
    bool isGrey = false;  ///< the first one stands for red, green and blue

    /// Takes the channels whose names begin with `layer` and have nothing but a usual word after it.
    void takeLayer(const std::vector<std::string>& all, const std::string& layer) {
        constexpr std::array<std::array<const char*, 2>, 4> kWords{
            {{"r", "red"}, {"g", "green"}, {"b", "blue"}, {"a", "alpha"}}};
        for (const std::string& each : all) {
            if (each.substr(0, each.rfind('.') + 1) != layer) continue;
            for (size_t c = 0; c < 4; ++c)
                for (const char* word : kWords.at(c))
                    if (lastWord(each) == word && names.at(c).empty()) names.at(c) = each;
        }
    }
    [[nodiscard]] int colors() const {
        return static_cast<int>(
            std::count_if(names.begin(), names.begin() + 3, [](const auto& each) { return !each.empty(); }));
    }
};

/// Red, green and blue of the main layer, or its luminance; or else those of the first layer that has any; or
/// else the first channel as grey.
ExrChannels channelsIn(const Imf::Header& header) {
    std::vector<std::string> all, layers{""};
    for (auto each = header.channels().begin(); each != header.channels().end(); ++each) {
        all.emplace_back(each.name());
        const std::string layer = all.back().substr(0, all.back().rfind('.') + 1);
        if (std::find(layers.begin(), layers.end(), layer) == layers.end()) layers.push_back(layer);
    }
    if (all.empty()) throw Failure{"it has no channels"};
    for (const std::string& layer : layers) {
        ExrChannels found;
        found.takeLayer(all, layer);
        if (found.colors() > 1) return found;
        const auto luminance = std::find_if(all.begin(), all.end(), [&](const std::string& each) {
            return each.substr(0, each.rfind('.') + 1) == layer && lastWord(each) == "y";
        });
        if (found.colors() == 0 && luminance == all.end()) continue;
        for (size_t c = 0; c < 3; ++c)
            if (!found.names.at(c).empty()) std::swap(found.names[0], found.names.at(c));
        if (found.colors() == 0) found.names[0] = *luminance;
        found.isGrey = true;
        return found;
    }
    ExrChannels first;
    first.names[0] = lastWord(all.front()) == "a" && all.size() > 1 ? all[1] : all.front();
    first.isGrey = true;
    return first;
}

void readExrPart(Imf::MultiPartInputFile& file, int part, const GlibraReadRequest& request) {
    const Imf::Header& header = file.header(part);
    const ExrChannels channels = channelsIn(header);
    const ExrCanvas canvas(request, header, !channels.names[3].empty());
    if (canvas.firstRow() > canvas.lastRow() || canvas.firstColumn() > canvas.lastColumn()) return;

    // One row of all channels. The library converts halves and whole numbers to floats.
    const Imath::Box2i& data = canvas.data();
    const auto width = static_cast<size_t>(int64_t{data.max.x} - data.min.x + 1);
    std::array<std::vector<float>, 4> rows;
    Imf::FrameBuffer buffer;
    for (size_t c = 0; c < 4; ++c) {
        const std::string& name = channels.names.at(c);
        if (name.empty()) continue;
        const Imf::Channel* const channel = header.channels().findChannel(name);
        if (channel == nullptr || channel->xSampling != 1 || channel->ySampling != 1)
            throw Failure{"channel " + name + " does not have every pixel"};
        rows.at(c).resize(width);
        char* const base = reinterpret_cast<char*>(rows.at(c).data()) -
                           static_cast<ptrdiff_t>(data.min.x) * static_cast<ptrdiff_t>(sizeof(float));
        buffer.insert(name, Imf::Slice(Imf::FLOAT, base, sizeof(float), 0));
    }
    Imf::InputPart input(file, part);
    input.setFrameBuffer(buffer);
    for (int y = canvas.firstRow(); y <= canvas.lastRow(); ++y) {
        input.readPixels(y);
        float* to = canvas.at(canvas.firstColumn(), y);
        for (int x = canvas.firstColumn(); x <= canvas.lastColumn(); ++x, to += 4) {
            const auto from = static_cast<size_t>(int64_t{x} - data.min.x);
            for (size_t c = 0; c < 4; ++c)
                if (!rows.at(c).empty()) to[c] = rows.at(c)[from];
            if (channels.isGrey) to[1] = to[2] = to[0];
        }
    }
}

/// Luminance with colours of half the resolution, which the library converts.
void readLuminanceChroma(ExrBytes& stream, const GlibraReadRequest& request) {
    Imf::RgbaInputFile file(stream);
    const ExrCanvas canvas(request, file.header(), (file.channels() & Imf::WRITE_A) != 0);
    if (canvas.firstRow() > canvas.lastRow() || canvas.firstColumn() > canvas.lastColumn()) return;
    const Imath::Box2i& data = canvas.data();
    std::vector<Imf::Rgba> row(static_cast<size_t>(int64_t{data.max.x} - data.min.x + 1));
    file.setFrameBuffer(row.data() - data.min.x, 1, 0);
    for (int y = canvas.firstRow(); y <= canvas.lastRow(); ++y) {
        file.readPixels(y);
        for (int x = canvas.firstColumn(); x <= canvas.lastColumn(); ++x) {
            const Imf::Rgba& from = row[static_cast<size_t>(int64_t{x} - data.min.x)];
            const std::array<float, 4> pixel{from.r, from.g, from.b, from.a};
            std::memcpy(canvas.at(x, y), pixel.data(), sizeof pixel);
        }
    }
}

}  // namespace

void readExr(const GlibraReadRequest& request) {
    Imf::setGlobalThreadCount(0);
    ExrBytes stream(request);
    Imf::MultiPartInputFile file(stream, 0);
    for (int part = 0; part < file.parts(); ++part) {
        const Imf::Header& header = file.header(part);
        if (header.hasType() && !Imf::isImage(header.type())) continue;
        const auto& channels = header.channels();
        const bool hasChroma = channels.findChannel("RY") != nullptr || channels.findChannel("BY") != nullptr;
        if (!hasChroma || channels.findChannel("R") != nullptr) return readExrPart(file, part, request);
        if (file.parts() > 1) throw Failure{"luminance and chroma in one of several parts"};
        stream.seekg(0);
        return readLuminanceChroma(stream, request);
    }
    throw Failure{"it is a deep picture"};
}

}  // namespace glibra::module
