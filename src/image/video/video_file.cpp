#include "image/video/video_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
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

namespace glibra::image {
namespace {

namespace fs = std::filesystem;

std::string suffixOf(const fs::path& file) {
    return base::lower(file.extension().string());
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
    words.push_back("file:" + file.string());  // a name with a colon is not a protocol
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
    const char* folders = std::getenv("PATH");
    std::string_view rest = folders ? folders : "";
    while (!rest.empty()) {
        const std::string folder(rest.substr(0, rest.find(':')));
        if (!folder.empty() && ::access((folder + "/ffmpeg").c_str(), X_OK) == 0) return true;
        rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    }
    return false;
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
    pid_t process = -1;
    int input = -1;
    std::variant<std::monostate, AnimatedPng, AnimatedGif> frames;  ///< of a file that needs no process

    [[nodiscard]] Diagnostics bad(const std::string& why) const {
        return {diagnose("file-E10", fmt::format("cannot write '{}': {}", file.string(), why))};
    }

    void start(std::vector<std::string> command) {
        std::vector<char*> words;
        words.reserve(command.size() + 1);
        for (std::string& each : command) words.push_back(each.data());
        words.push_back(nullptr);
        messages.reset(std::tmpfile());
        // With a socket in place of a pipe, writing to an encoder that has ended is an error, not a signal.
        std::array<int, 2> ends{-1, -1};
        if (!messages || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, ::fileno(messages.get()), STDERR_FILENO);
        if (posix_spawnp(&process, "ffmpeg", &actions, nullptr, words.data(), environ) != 0) process = -1;
        posix_spawn_file_actions_destroy(&actions);
        ::close(ends[0]);
        input = ends[1];
    }

    /// Waits for ffmpeg. Returns true if it succeeded.
    bool end() {
        if (input >= 0) ::close(input);
        input = -1;
        if (process <= 0) return false;
        int status = 0;
        pid_t ended = -1;
        do ended = ::waitpid(process, &status, 0);
        while (ended < 0 && errno == EINTR);
        const bool succeeded = ended == process && WIFEXITED(status) && WEXITSTATUS(status) == 0;
        process = -1;
        return succeeded;
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
    if (state->process <= 0) return state->bad("ffmpeg cannot be started");
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
    std::span<const std::byte> rest = converted ? converted->data : frame.data;
    while (!rest.empty()) {
        const ssize_t sent = ::send(state_->input, rest.data(), rest.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return state_->failed();
        rest = rest.subspan(static_cast<std::size_t>(sent));
    }
    return {};
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
