#include "image/video/video_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>

#include "base/text.h"
#include "image/file.h"
#include "image/png/png_writer.h"
#include "system/process.h"

namespace glibra::image {
namespace {

struct Indexed {
    std::vector<std::array<std::uint8_t, 3>> palette;  ///< 1 to 256 colours
    std::vector<std::uint8_t> pixels;                  ///< indices into it, top row first
};

constexpr std::size_t kLargestPalette = 256;

using Rgb = std::array<std::uint8_t, 3>;

Rgb rgbAt(const Image& rgb, std::size_t pixel) {
    return {std::to_integer<std::uint8_t>(rgb.data[3 * pixel]),
            std::to_integer<std::uint8_t>(rgb.data[3 * pixel + 1]),
            std::to_integer<std::uint8_t>(rgb.data[3 * pixel + 2])};
}

std::uint32_t rgbKey(const Rgb& color) {
    return color[0] | std::uint32_t{color[1]} << 8U | std::uint32_t{color[2]} << 16U;
}

/// The picture with its own colours; nothing if these are more than 256.
std::optional<Indexed> exactly(const Image& rgb) {
    Indexed made;
    std::unordered_map<std::uint32_t, std::uint8_t> known;
    const std::size_t count = rgb.data.size() / 3;
    made.pixels.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Rgb color = rgbAt(rgb, i);
        const auto [place, isNew] =
            known.try_emplace(rgbKey(color), static_cast<std::uint8_t>(made.palette.size()));
        if (isNew) {
            if (made.palette.size() == kLargestPalette) return std::nullopt;
            made.palette.push_back(color);
        }
        made.pixels.push_back(place->second);
    }
    return made;
}

/// The pixels whose colours agree in their upper five bits.
struct Bin {
    double weight = 0;
    std::array<double, 3> sum{}, squares{};

    void add(const Bin& other) {
        weight += other.weight;
        for (std::size_t c = 0; c < 3; ++c) {
            sum[c] += other.sum[c];
            squares[c] += other.squares[c];
        }
    }
    [[nodiscard]] double mean(std::size_t c) const { return sum[c] / weight; }
    /// The sum of the squared distances from the mean.
    [[nodiscard]] double spread(std::size_t c) const { return squares[c] - sum[c] * sum[c] / weight; }
};

constexpr unsigned kBinBits = 5;

std::size_t binOf(const Rgb& color) {
    return std::size_t{color[0]} >> (8 - kBinBits) << (2 * kBinBits) |
           std::size_t{color[1]} >> (8 - kBinBits) << kBinBits | std::size_t{color[2]} >> (8 - kBinBits);
}

struct Box {
    std::size_t begin = 0, end = 0;  ///< of the bins
    Bin all;
    std::size_t axis = 0;  ///< with the largest spread
    double spread = 0;
};

Box boxOf(const std::vector<Bin>& bins, std::size_t begin, std::size_t end) {
    Box box{begin, end, {}, 0, 0};
    for (std::size_t i = begin; i < end; ++i) box.all.add(bins[i]);
    for (std::size_t c = 0; c < 3; ++c)
        if (const double spread = box.all.spread(c); spread > box.spread) {
            box.spread = spread;
            box.axis = c;
        }
    if (end - begin < 2) box.spread = 0;  // it cannot be cut
    return box;
}

/// Cuts the box with the largest spread at its mean, until there are enough.
std::vector<Rgb> medianCut(const Image& rgb) {
    std::vector<Bin> all(std::size_t{1} << (3 * kBinBits));
    for (std::size_t i = 0; i < rgb.data.size() / 3; ++i) {
        const Rgb color = rgbAt(rgb, i);
        Bin& bin = all[binOf(color)];
        ++bin.weight;
        for (std::size_t c = 0; c < 3; ++c) {
            bin.sum[c] += color[c];
            bin.squares[c] += double{1} * color[c] * color[c];
        }
    }
    std::erase_if(all, [](const Bin& each) { return each.weight == 0; });
    std::vector<Box> boxes{boxOf(all, 0, all.size())};
    while (boxes.size() < kLargestPalette) {
        const auto widest = std::max_element(boxes.begin(), boxes.end(),
                                             [](const Box& a, const Box& b) { return a.spread < b.spread; });
        if (widest->spread <= 0) break;
        const std::size_t axis = widest->axis;
        const double middle = widest->all.mean(axis);
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(widest->begin);
        const auto end = all.begin() + static_cast<std::ptrdiff_t>(widest->end);
        auto cut = std::partition(begin, end, [&](const Bin& each) { return each.mean(axis) < middle; });
        if (cut == begin || cut == end) cut = begin + 1;  // equal means, up to rounding
        const auto at = static_cast<std::size_t>(cut - all.begin());
        const Box low = boxOf(all, widest->begin, at), high = boxOf(all, at, widest->end);
        *widest = low;
        boxes.push_back(high);
    }
    std::vector<Rgb> palette;
    for (const Box& each : boxes) {
        Rgb& color = palette.emplace_back();
        for (std::size_t c = 0; c < 3; ++c)
            color[c] = static_cast<std::uint8_t>(std::lround(each.all.mean(c)));
    }
    return palette;
}

class Nearest {
  public:
    explicit Nearest(const std::vector<Rgb>& palette) : palette_(palette) {}

    /// The index of the nearest colour; colours that agree in six bits each are taken as one.
    std::uint8_t operator()(const Rgb& color) {
        int& known = known_[std::size_t{color[0]} >> 2U << 12U | std::size_t{color[1]} >> 2U << 6U |
                            std::size_t{color[2]} >> 2U];
        if (known >= 0) return static_cast<std::uint8_t>(known);
        int least = std::numeric_limits<int>::max();
        for (std::size_t i = 0; i < palette_.size(); ++i) {
            int distance = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const int apart = int{palette_[i][c]} - int{color[c]};
                distance += apart * apart;
            }
            if (distance >= least) continue;
            least = distance;
            known = static_cast<int>(i);
        }
        return static_cast<std::uint8_t>(known);
    }

  private:
    const std::vector<Rgb>& palette_;
    std::vector<int> known_ = std::vector<int>(std::size_t{1} << 18U, -1);
};

void diffuse(const Image& rgb, Indexed& made) {
    const auto width = static_cast<std::size_t>(rgb.width);
    Nearest nearest(made.palette);
    // The errors of a row and of the next one, in sixteenths, with a pixel more at each end.
    std::vector<std::array<int, 3>> here(width + 2), below(width + 2);
    made.pixels.reserve(width * static_cast<std::size_t>(rgb.height));
    for (std::size_t y = 0; y < static_cast<std::size_t>(rgb.height); ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            Rgb wanted = rgbAt(rgb, y * width + x);
            std::array<int, 3> exact{};
            for (std::size_t c = 0; c < 3; ++c) {
                exact[c] = std::clamp(wanted[c] + here[x + 1][c] / 16, 0, 255);
                wanted[c] = static_cast<std::uint8_t>(exact[c]);
            }
            const std::uint8_t index = nearest(wanted);
            made.pixels.push_back(index);
            for (std::size_t c = 0; c < 3; ++c) {
                const int error = exact[c] - made.palette[index][c];
                here[x + 2][c] += 7 * error;
                below[x][c] += 3 * error;
                below[x + 1][c] += 5 * error;
                below[x + 2][c] += error;
            }
        }
        here.swap(below);
        std::fill(below.begin(), below.end(), std::array<int, 3>{});
    }
}

/// A picture (RGB, u8, not empty) with a palette: exact if it has 256 colours at most, otherwise with the
/// colours of median cut, and the error of each pixel given to its neighbours.
Indexed indexed(const Image& rgb) {
    if (std::optional<Indexed> made = exactly(rgb)) return *std::move(made);
    Indexed made{medianCut(rgb), {}};
    diffuse(rgb, made);
    return made;
}

constexpr int kRgbComponents = 3;
constexpr long long kShortestFrame = 2;  // hundredths of a second

void putGifText(std::vector<std::byte>& to, std::string_view text) {
    for (const char each : text) to.push_back(static_cast<std::byte>(each));
}

void putLittle16(std::vector<std::byte>& to, unsigned value) {
    to.push_back(static_cast<std::byte>(value & 0xffU));
    to.push_back(static_cast<std::byte>(value >> 8U & 0xffU));
}

/// The codes of the pixels (GIF89a, appendix F), in blocks of up to 255 bytes.
class CodeWriter {
  public:
    CodeWriter(std::vector<std::byte>& to, unsigned bits) : to_(to), bits_(bits) {
        to_.push_back(static_cast<std::byte>(bits));
        clear();
    }

    void add(std::uint8_t pixel) {
        if (prefix_ < 0) {
            prefix_ = pixel;
            return;
        }
        std::uint16_t& next = next_[static_cast<std::size_t>(prefix_) << 8U | pixel];
        if (next != 0) {
            prefix_ = next;
            return;
        }
        put(static_cast<unsigned>(prefix_));
        prefix_ = pixel;
        if (free_ == kMostCodes) return clear();
        next = static_cast<std::uint16_t>(free_);
        if (free_++ == 1U << width_) ++width_;
    }

    void finish() {
        if (prefix_ >= 0) put(static_cast<unsigned>(prefix_));
        // A decoder has as many codes now: it adds one for each that it reads, except for the first.
        if (free_ == 1U << width_ && free_ < kMostCodes) ++width_;
        put((1U << bits_) + 1);
        if (filled_ > 0) block_.push_back(static_cast<std::byte>(buffer_ & 0xffU));
        endBlock();
        to_.push_back(std::byte{0});
    }

  private:
    static constexpr unsigned kMostCodes = 4096;

    void clear() {
        std::fill(next_.begin(), next_.end(), std::uint16_t{0});
        free_ = (1U << bits_) + 2;
        if (width_ == 0) width_ = bits_ + 1;
        put(1U << bits_);
        width_ = bits_ + 1;
    }
    void put(unsigned code) {
        buffer_ |= code << filled_;
        filled_ += width_;
        for (; filled_ >= 8; filled_ -= 8, buffer_ >>= 8U) {
            block_.push_back(static_cast<std::byte>(buffer_ & 0xffU));
            constexpr std::size_t kLongest = 255;
            if (block_.size() == kLongest) endBlock();
        }
    }
    void endBlock() {
        if (block_.empty()) return;
        to_.push_back(static_cast<std::byte>(block_.size()));
        to_.insert(to_.end(), block_.begin(), block_.end());
        block_.clear();
    }

    std::vector<std::byte>& to_;
    const unsigned bits_;  ///< of a pixel
    /// By a code and the pixel after it: the code of both; 0: none.
    std::vector<std::uint16_t> next_ = std::vector<std::uint16_t>(std::size_t{kMostCodes} << 8U);
    std::vector<std::byte> block_;
    std::uint32_t buffer_ = 0;
    unsigned filled_ = 0;  ///< bits of the buffer
    unsigned width_ = 0;   ///< bits of a code
    unsigned free_ = 0;    ///< the next code
    int prefix_ = -1;      ///< the code of the pixels that are not written yet
};

/// A frame: its delay, place and pixels. Returns where the delay stands.
std::size_t putFrame(std::vector<std::byte>& to, const Image& part, int left, int top) {
    constexpr std::string_view kControl("\x21\xf9\x04\x04", 4);  // what is there stays
    putGifText(to, kControl);
    const std::size_t delayAt = to.size();
    putLittle16(to, 0);
    to.insert(to.end(), 2, std::byte{0});
    const Indexed made = indexed(part);
    const auto colors = std::max<std::size_t>(2, std::bit_ceil(made.palette.size()));
    const auto bits = static_cast<unsigned>(std::countr_zero(colors));
    to.push_back(std::byte{0x2c});
    for (const int each : {left, top, part.width, part.height}) putLittle16(to, static_cast<unsigned>(each));
    to.push_back(static_cast<std::byte>(0x80U | (bits - 1)));
    for (std::size_t i = 0; i < colors; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            to.push_back(i < made.palette.size() ? static_cast<std::byte>(made.palette[i][c]) : std::byte{0});
    CodeWriter codes(to, std::max(2U, bits));
    for (const std::uint8_t each : made.pixels) codes.add(each);
    codes.finish();
    return delayAt;
}

}  // namespace

long long AnimatedGif::hundredthsAt(long long frame) const {
    constexpr double kHundredths = 100, kLongest = 1e15;
    return std::llround(
        std::min(kLongest, kHundredths * static_cast<double>(frame) / std::max(1e-9, framesPerSecond_)));
}

/// The frame that is shown ends where the next one begins.
void AnimatedGif::endShown() {
    constexpr long long kLongest = 65'535;
    const auto delay =
        static_cast<unsigned>(std::clamp(hundredthsAt(added_) - shownSince_, kShortestFrame, kLongest));
    body_[delayAt_] = static_cast<std::byte>(delay & 0xffU);
    body_[delayAt_ + 1] = static_cast<std::byte>(delay >> 8U);
}

void AnimatedGif::add(const Image& frame) {
    const long long begin = hundredthsAt(added_);
    if (stored_ > 0 && begin - shownSince_ < kShortestFrame) {
        ++added_;
        return;
    }
    Image next = withComponents(withType(frame, Component::u8), kRgbComponents);
    const Bounds bounds = stored_ == 0 ? Bounds{0, 0, next.width, next.height} : differenceOf(last_, next);
    if (!bounds.isEmpty()) {
        if (stored_ > 0) endShown();
        delayAt_ = putFrame(body_, partOf(next, bounds), bounds.left, bounds.top);
        shownSince_ = begin;
        ++stored_;
    }
    ++added_;
    last_ = std::move(next);
}

std::vector<std::byte> AnimatedGif::finish() {
    if (stored_ == 0) return {};
    std::vector<std::byte> file;
    putGifText(file, "GIF89a");
    putLittle16(file, static_cast<unsigned>(last_.width));
    putLittle16(file, static_cast<unsigned>(last_.height));
    putGifText(file, std::string_view("\x70\0\0", 3));  // eight bits per colour, no palette for all
    if (added_ > 1) {
        endShown();
        putGifText(file, std::string_view("\x21\xff\x0bNETSCAPE2.0\x03\x01\0\0\0", 19));  // for ever
    }
    file.insert(file.end(), body_.begin(), body_.end());
    file.push_back(std::byte{0x3b});
    return file;
}

std::vector<std::byte> encodeGif(const Image& image) {
    AnimatedGif file(1);
    file.add(image);
    return file.finish();
}

namespace {

namespace fs = std::filesystem;

std::string suffixOf(const fs::path& file) {
    return base::lower(file.extension().generic_string());
}

/// The words of the command. The options before "-i" describe the pixels that ffmpeg reads.
std::vector<std::string> commandOf(const fs::path& file, int width, int height, double framesPerSecond,
                                   const std::string& comment) {
    std::vector<std::string> words{"ffmpeg",
                                   "-nostdin",
                                   "-v",
                                   "error",
                                   "-y",
                                   "-f",
                                   "rawvideo",
                                   "-pix_fmt",
                                   "rgb24",
                                   "-video_size",
                                   fmt::format("{}x{}", width, height),
                                   "-framerate",
                                   fmt::format("{}", framesPerSecond),
                                   "-i",
                                   "pipe:0"};
    words.insert(words.end(), {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-metadata",
                               "comment=" + comment});
    words.push_back("file:" + file.generic_string());  // a name with a colon is not a protocol
    return words;
}

/// The last line of a file; empty if it has none.
std::string lastLine(std::FILE* file) {
    if (std::fseek(file, 0, SEEK_SET) != 0) return {};
    std::array<char, 1024> buffer{};
    std::string last;
    while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), file)) {
        std::string line(buffer.data());
        while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())) != 0) line.pop_back();
        if (!line.empty()) last = std::move(line);
    }
    return last;
}

}  // namespace

bool isVideo(const fs::path& file) {
    constexpr std::array<std::string_view, 5> kSuffixes{".mp4", ".webm", ".mkv", ".mov", ".avi"};
    return std::find(kSuffixes.begin(), kSuffixes.end(), suffixOf(file)) != kSuffixes.end();
}

bool holdsAnimation(const fs::path& file) {
    return isVideo(file) || suffixOf(file) == ".gif" || suffixOf(file) == ".apng";
}

bool hasFfmpeg() {
    return !system::findInPath("ffmpeg").empty();
}

struct VideoFile::State {
    State(const fs::path& wanted, int wantedWidth, int wantedHeight)
        : file(wanted), width(wantedWidth), height(wantedHeight), unfinished(wanted) {}
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() { end(); }

    struct CloseFile {
        void operator()(std::FILE* stream) const { std::fclose(stream); }
    };

    fs::path file;
    int width, height;
    TemporaryFile unfinished;
    std::unique_ptr<std::FILE, CloseFile> messages;  ///< what ffmpeg prints
    system::Process process;
    system::File input;
    std::variant<std::monostate, AnimatedPng, AnimatedGif> frames;  ///< of a file that needs no process

    [[nodiscard]] Diagnostics bad(const std::string& why) const {
        return {diagnose("file-E10", fmt::format("cannot write '{}': {}", file.generic_string(), why))};
    }

    void start(const std::vector<std::string>& command) {
        messages.reset(std::tmpfile());
        system::File theirs;
        if (!messages || system::makeInputOf(theirs, input) != 0) return;
        process = system::startProgram(command, {theirs, system::Stream::To::nothing, messages.get()});
    }

    /// Waits for ffmpeg. Returns true if it succeeded.
    bool end() {
        input.close();
        return process && waitFor(process).isGood();
    }

    Diagnostics failed() {
        end();
        const std::string message = messages ? lastLine(messages.get()) : std::string();
        return bad(message.empty() ? "ffmpeg reported an error" : "ffmpeg: " + message);
    }
};

VideoFile::VideoFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
VideoFile::VideoFile(VideoFile&&) noexcept = default;
VideoFile& VideoFile::operator=(VideoFile&&) noexcept = default;
VideoFile::~VideoFile() = default;

Result<VideoFile> VideoFile::create(const fs::path& file, int width, int height, double framesPerSecond,
                                    const std::string& comment) {
    auto state = std::make_unique<State>(file, width, height);
    if (!isVideo(file)) {
        if (suffixOf(file) != ".gif")
            state->frames.emplace<AnimatedPng>(framesPerSecond);
        else if (std::max(width, height) > kLargestGifSide)
            return state->bad(fmt::format("GIF has at most {} pixels per side", kLargestGifSide));
        else
            state->frames.emplace<AnimatedGif>(framesPerSecond);
        return VideoFile(std::move(state));
    }
    if (!hasFfmpeg()) return state->bad(kFfmpegIsMissing);
    if (state->unfinished.path().empty()) return Diagnostics{state->unfinished.failure()};
    state->start(commandOf(state->unfinished.path(), width, height, framesPerSecond, comment));
    if (!state->process) return state->bad("ffmpeg cannot be started");
    return VideoFile(std::move(state));
}

Diagnostics VideoFile::add(const Image& frame) {
    if (frame.width != state_->width || frame.height != state_->height)
        return state_->bad(fmt::format("a frame has {} x {} pixels, the first one {} x {}", frame.width,
                                       frame.height, state_->width, state_->height));
    if (auto* png = std::get_if<AnimatedPng>(&state_->frames)) return png->add(frame), Diagnostics();
    if (auto* gif = std::get_if<AnimatedGif>(&state_->frames)) return gif->add(frame), Diagnostics();
    std::optional<Image> converted;
    if (frame.components != 3 || frame.type != Component::u8)
        converted = withComponents(withType(frame, Component::u8), 3);
    return sendAll(state_->input, converted ? converted->data : frame.data) == 0 ? Diagnostics()
                                                                                 : state_->failed();
}

Diagnostics VideoFile::finish() {
    if (state_->frames.index() != 0) {
        auto* png = std::get_if<AnimatedPng>(&state_->frames);
        const std::vector<std::byte> file =
            png ? png->finish() : std::get<AnimatedGif>(state_->frames).finish();
        return file.empty() ? state_->bad("there is not enough memory")
                            : writeFileAtomically(state_->file, file);
    }
    if (!state_->end()) return state_->failed();
    return state_->unfinished.commit();
}

}  // namespace glibra::image
