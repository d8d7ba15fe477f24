// Frames to a video by the program ffmpeg: raw pixels into its standard input.

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <string>
#include <vector>

#include "image/file.h"
#include "render/scene_renderer.h"
#include "view/hardcopy.h"

namespace glibra::view {
namespace {

/// A running ffmpeg. Its messages are thrown away; its exit status says how it went.
class Encoder {
  public:
    explicit Encoder(std::vector<std::string> arguments) {
        std::array<int, 2> ends{-1, -1};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        std::vector<char*> words;
        words.reserve(arguments.size() + 1);
        for (std::string& each : arguments) words.push_back(each.data());
        words.push_back(nullptr);
        if (posix_spawnp(&process_, "ffmpeg", &actions, nullptr, words.data(), environ) != 0) process_ = -1;
        posix_spawn_file_actions_destroy(&actions);
        ::close(ends[0]);
        input_ = ends[1];
    }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
    ~Encoder() { finish(); }

    [[nodiscard]] bool isRunning() const { return process_ > 0; }
    bool write(std::span<const std::byte> bytes) const {
        while (!bytes.empty()) {
            const ssize_t written = ::write(input_, bytes.data(), bytes.size());
            if (written <= 0) return false;
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
        return true;
    }
    /// True if it ended well.
    bool finish() {
        if (input_ >= 0) ::close(input_);
        input_ = -1;
        if (process_ <= 0) return false;
        int status = 0;
        const bool ended = ::waitpid(process_, &status, 0) == process_;
        process_ = -1;
        return ended && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }

  private:
    pid_t process_ = -1;
    int input_ = -1;
};

}  // namespace

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

Diagnostics writeVideo(gpu::Context& context, const Session& session, const Hardcopy& wanted,
                       const std::function<bool(int)>& progress) {
    const auto bad = [&](const std::string& why) {
        return error("file-E10", fmt::format("cannot write '{}': {}", wanted.file.string(), why));
    };
    if (!hasFfmpeg()) return {bad("the program ffmpeg is not installed; write single frames instead")};
    const RenderOptions options = session.renderOptions(wanted.width, wanted.height);
    render::Stats stats;
    Result<render::SceneRenderer> loaded =
        render::SceneRenderer::load(context, session.path(), options, stats);
    Diagnostics diagnostics = std::move(loaded.diagnostics);
    if (!loaded) return diagnostics;
    // Video formats want even sizes; one row or column of the edge is repeated where it is odd.
    image::TemporaryFile unfinished(wanted.file);
    Encoder encoder({"ffmpeg", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s",
                     fmt::format("{}x{}", options.width, options.height), "-r",
                     fmt::format("{}", wanted.framesPerSecond), "-i", "-", "-vf",
                     "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", unfinished.path().string()});
    if (!encoder.isRunning()) return {bad("ffmpeg cannot be started")};
    // An encoder that ends early is told by write(), not by a signal.
    struct sigaction ignore {};
    struct sigaction before {};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGPIPE, &ignore, &before);
    bool taken = true;
    for (int i = 0; i < wanted.frames && taken; ++i) {
        Result<image::Image> picture = loaded->draw(options.time + i / wanted.framesPerSecond, stats);
        append(diagnostics, std::move(picture.diagnostics));
        if (!picture) break;
        taken = encoder.write(picture->data) && (!progress || progress(i + 1));
    }
    const bool encoded = encoder.finish();
    ::sigaction(SIGPIPE, &before, nullptr);
    if (hasError(diagnostics)) return diagnostics;
    if (!encoded || !taken) return {bad("ffmpeg refuses it")};
    append(diagnostics, unfinished.commit());
    return diagnostics;
}

}  // namespace glibra::view
