#include "view/export/video_encoder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace glibra::view {

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

VideoEncoder::VideoEncoder(const std::filesystem::path& file, int width, int height, double framesPerSecond,
                           const std::string& comment) {
    // Video formats need even sizes; a black row or column is added to an odd size.
    std::vector<std::string> arguments{"ffmpeg",     "-y",
                                       "-f",         "rawvideo",
                                       "-pix_fmt",   "rgb24",
                                       "-s",         fmt::format("{}x{}", width, height),
                                       "-r",         fmt::format("{}", framesPerSecond),
                                       "-i",         "-",
                                       "-vf",        "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                       "-pix_fmt",   "yuv420p",
                                       "-metadata",  "comment=" + comment,
                                       file.string()};
    std::vector<char*> words;
    words.reserve(arguments.size() + 1);
    for (std::string& each : arguments) words.push_back(each.data());
    words.push_back(nullptr);
    // With a socket in place of a pipe, writing to an encoder that has ended is an error, not a signal.
    std::array<int, 2> ends{-1, -1};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    if (posix_spawnp(&process_, "ffmpeg", &actions, nullptr, words.data(), environ) != 0) process_ = -1;
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[0]);
    input_ = ends[1];
}

bool VideoEncoder::write(std::span<const std::byte> frame) const {
    while (!frame.empty()) {
        const ssize_t written = ::send(input_, frame.data(), frame.size(), MSG_NOSIGNAL);
        if (written <= 0) return false;
        frame = frame.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

bool VideoEncoder::finish() {
    if (input_ >= 0) ::close(input_);
    input_ = -1;
    if (process_ <= 0) return false;
    int status = 0;
    const bool ended = ::waitpid(process_, &status, 0) == process_;
    process_ = -1;
    return ended && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace glibra::view
