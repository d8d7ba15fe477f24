#include "image/video/video_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/text.h"
#include "image/convert.h"
#include "image/file.h"
#include "image/png/png_writer.h"
#include "image/video/gif_writer.h"
#include "system/process.h"

namespace glibra::image {
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
