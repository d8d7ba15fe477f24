#include "view/browse/thumbnail_maker.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <system_error>
#include <utility>

#include "gpu/context/context.h"
#include "view/browse/thumbnails.h"
#include "view/edit/detached_process.h"

namespace glibra::view {
namespace {

constexpr int kLongestScene = 30'000;  ///< milliseconds
constexpr int kNiceness = 10;
constexpr int kNoDriver = 4;  ///< exit status

}  // namespace

ThumbnailMaker::ThumbnailMaker(std::filesystem::path folder, std::vector<std::filesystem::path> scenes,
                               std::function<void()> wake)
    : folder_(std::move(folder)),
      scenes_(std::move(scenes)),
      wake_(std::move(wake)),
      stop_(::eventfd(0, EFD_CLOEXEC)) {
    // finish() must not allocate: it also reports the scenes that no memory is left for.
    finished_.reserve(scenes_.size());
    try {
        thread_ = std::thread([this] { run(); });
    } catch (const std::system_error&) {
        for (std::size_t i = 0; i < scenes_.size(); ++i) finish(i);
    }
}

ThumbnailMaker::~ThumbnailMaker() {
    if (thread_.joinable()) {
        const std::uint64_t one = 1;
        if (::write(stop_, &one, sizeof one) == sizeof one)
            thread_.join();
        else
            thread_.detach();
    }
    ::close(stop_);
}

std::vector<std::filesystem::path> ThumbnailMaker::takeFinished() {
    const std::scoped_lock lock(mutex_);
    std::vector<std::filesystem::path> files;
    files.reserve(finished_.size());
    for (const std::size_t each : finished_) files.push_back(scenes_[each]);
    finished_.clear();
    return files;
}

bool ThumbnailMaker::hasFinished() {
    const std::scoped_lock lock(mutex_);
    return !finished_.empty();
}

void ThumbnailMaker::finish(std::size_t scene) {
    {
        const std::scoped_lock lock(mutex_);
        finished_.push_back(scene);
    }
    wake_();
}

std::size_t ThumbnailMaker::runProcess(std::size_t first, const char*& why) {
    std::vector<std::string> words{"glibra-view", "--thumbnails", folder_.string()};
    for (std::size_t i = first; i < scenes_.size(); ++i) words.push_back(scenes_[i].string());
    // Nothing below allocates in this process, so that no exception can leave the pipe open.
    std::array<int, 2> pipe{-1, -1};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) return scenes_.size();
    const pid_t process = startAgain(std::move(words), {{pipe[1], STDOUT_FILENO}});
    ::close(pipe[1]);
    std::size_t done = process < 0 ? scenes_.size() : first;
    why = "the program that drew it ended unexpectedly";
    while (done < scenes_.size()) {
        std::array<pollfd, 2> wanted{{{pipe[0], POLLIN, 0}, {stop_, POLLIN, 0}}};
        const int ready = ::poll(wanted.data(), wanted.size(), kLongestScene);
        if (wanted[1].revents != 0) {
            ::kill(process, SIGKILL);
            done = scenes_.size();
            break;
        }
        if (ready == 0) {
            ::kill(process, SIGKILL);
            why = "drawing it takes longer than 30 seconds";
            break;
        }
        std::array<char, 64> answers{};
        const ssize_t length = ready > 0 ? ::read(pipe[0], answers.data(), answers.size()) : 0;
        if (length <= 0) break;
        for (auto lines = std::count(answers.begin(), answers.begin() + length, '\n');
             lines > 0 && done < scenes_.size(); --lines)
            finish(done++);
    }
    ::close(pipe[0]);
    int status = 0;
    if (process >= 0) ::waitpid(process, &status, 0);
    // Without a driver that draws off screen there are no pictures of any scene.
    if (WIFEXITED(status) && WEXITSTATUS(status) == kNoDriver)
        while (done < scenes_.size()) finish(done++);
    return done;
}

void ThumbnailMaker::run() {
    std::size_t next = 0;
    try {
        while (next < scenes_.size()) {
            const char* why = "";
            next = runProcess(next, why);
            if (next >= scenes_.size()) return;
            rememberFailure(folder_, scenes_[next], why);
            finish(next++);
        }
    } catch (const std::exception&) {
        // Out of memory: the remaining scenes have no picture this time.
        while (next < scenes_.size()) finish(next++);
    }
}

int makeThumbnails(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& scenes,
                   const std::vector<std::filesystem::path>& libraryRoots) {
    ::setpriority(PRIO_PROCESS, 0, kNiceness);
    gpu::prepareEnvironment();
    Result<gpu::Context> context = gpu::openContext();
    if (!context) return kNoDriver;
    for (const std::filesystem::path& each : scenes) {
        makeThumbnail(*context, folder, each, libraryRoots);
        std::puts("");
        std::fflush(stdout);
    }
    return 0;
}

}  // namespace glibra::view
