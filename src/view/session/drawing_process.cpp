#include "view/session/drawing_process.h"

#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <nlohmann/json.hpp>
#include <utility>

#include "view/edit/detached_process.h"
#include "view/session/drawing_messages.h"

namespace glibra::view {
namespace {

/// How long a picture is waited for when it is asked for; most are ready then.
constexpr double kPatience = .1;
/// Loading makes meshes and compiles programs, which ends.
constexpr double kLongestLoading = 60;

double secondsSinceTime(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double processorSecondsOf(pid_t process) {
    clockid_t clock{};
    timespec used{};
    if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &used) != 0) return 0;
    constexpr double kSecondsPerNanosecond = 1e-9;
    return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * kSecondsPerNanosecond;
}

}  // namespace

bool DrawingProcess::start() {
    std::array<int, 2> ends{-1, -1};
    memory_ = ::memfd_create("glibra picture", MFD_CLOEXEC);
    if (memory_ < 0 || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return false;
    socket_ = ends[0];
    process_ = startAgain({"glibra-view", "--draw-for-window"},
                          {{ends[1], kDrawingSocket}, {memory_, kDrawingMemory}});
    ::close(ends[1]);
    return process_ >= 0;
}

void DrawingProcess::unmap() {
    if (!pixels_.empty()) ::munmap(pixels_.data(), pixels_.size());
    pixels_ = {};
}

void DrawingProcess::end() {
    unmap();
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        int status = 0;
        while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
    }
    for (int* each : {&socket_, &memory_})
        if (*each >= 0) ::close(std::exchange(*each, -1));
    process_ = -1;
    received_.clear();
    isWorking_ = hasDrawn_ = false;
}

bool DrawingProcess::send(const DrawingOrder& order) {
    const std::size_t size =
        static_cast<std::size_t>(order.width) * static_cast<std::size_t>(order.height) * 4;
    if (pixels_.size() != size) {
        unmap();
        if (::ftruncate(memory_, static_cast<off_t>(size)) != 0) return false;
        void* const memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, memory_, 0);
        if (memory == MAP_FAILED) return false;
        pixels_ = {static_cast<std::byte*>(memory), size};
    }
    sent_ = order;
    isWorking_ = isLoading_ = true;
    begun_ = std::chrono::steady_clock::now();
    return sendMessage(socket_, order.text);
}

/// On a busy machine the process may not have had the processor.
bool DrawingProcess::isLate(double limit) const {
    constexpr double kMostWaiting = 5;
    const double passed = secondsSinceTime(begun_);
    if (isLoading_) return passed > kLongestLoading;
    return passed > limit &&
           (passed > kMostWaiting * limit || processorSecondsOf(process_) - processorSeconds_ > limit / 2);
}

DrawingProcess::State DrawingProcess::wait(double seconds, double limit) {
    const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    for (;;) {
        while (const std::optional<std::string> text = takeMessage(received_)) {
            const nlohmann::json answer = nlohmann::json::parse(*text, nullptr, false);
            if (answer.is_object() && answer.contains("diagnostics")) {
                diagnostics_ = diagnosticsOf(answer);
                isWorking_ = false;
                hasDrawn_ = true;
                return State::drawn;
            }
            isLoading_ = false;
            begun_ = std::chrono::steady_clock::now();
            processorSeconds_ = processorSecondsOf(process_);
        }
        const int left = static_cast<int>(std::max(0., (seconds - secondsSinceTime(start)) * 1000));
        pollfd wanted{socket_, POLLIN, 0};
        if (::poll(&wanted, 1, left) > 0) {
            std::array<char, 1 << 12> bytes{};
            const ssize_t length = ::recv(socket_, bytes.data(), bytes.size(), 0);
            if (length > 0) {
                received_.append(bytes.data(), static_cast<std::size_t>(length));
                continue;
            }
            const State why = hasDrawn_ || !isLoading_ ? State::ended : State::missing;
            end();
            return why;
        }
        if (isLate(limit)) {
            end();
            return State::late;
        }
        if (left == 0) return State::working;
    }
}

DrawingProcess::State DrawingProcess::draw(const DrawingOrder& wanted, double limit) {
    if (isWorking_ && sent_.loading != wanted.loading) end();
    if (isWorking_) return wait(0, limit);
    if ((process_ < 0 && !start()) || !send(wanted)) {
        end();
        return State::missing;
    }
    return wait(kPatience, limit);
}

}  // namespace glibra::view
