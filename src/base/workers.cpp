#include "base/workers.h"

#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <deque>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/descriptor.h"
#include "base/memory_limit.h"

namespace glibra::base {
namespace {

using Clock = std::chrono::steady_clock;

/// The shaders of a scene are the longest.
constexpr std::uint32_t kLargestMessage = 1U << 28U;

/// A process has one state of this kind, as it has one process id.
bool thisProcessIsWorker = false;

/// Of the step that this worker is at.
struct StepLimit {
    std::atomic<double> seconds{0};  ///< 0: no limit
    std::atomic<Clock::time_point> start{};
};
StepLimit thisStep;

enum class MessageKind : std::uint32_t { step, answer, deviceLost };
struct Header {
    MessageKind kind{};
    std::uint32_t bytes = 0;
};

double secondsOf(const WorkerOptions& options, std::size_t piece) {
    return options.timeoutOf ? options.timeoutOf(piece) : options.timeout;
}

std::uint64_t memoryOf(const WorkerOptions& options, std::size_t piece) {
    return options.memoryOf ? options.memoryOf(piece) : options.memory;
}

void send(int file, MessageKind kind, const std::string& text) {
    const Header header{kind, static_cast<std::uint32_t>(text.size())};
    if (writeAll(file, std::as_bytes(std::span(&header, 1))) != 0 || writeAll(file, text) != 0) ::_exit(1);
}

/// The worker's main loop: reads pieces and writes answers until the parent closes the pipe.
/// In a sandbox, `memory` is a limit that nothing in the worker can raise.
[[noreturn]] void servePieces(int requests, int answers, std::size_t count, const WorkerOptions& options,
                              const Work& work, std::uint64_t memory) {
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    // When memory runs out, the kernel should end a worker, not the parent that holds all results.
    if (std::FILE* score = std::fopen("/proc/self/oom_score_adj", "w")) {
        std::fputs("1000", score);
        std::fclose(score);
    }
#endif
    for (const int each : {SIGINT, SIGHUP, SIGQUIT}) ::signal(each, SIG_IGN);
    ::signal(SIGTERM, SIG_DFL);
    thisProcessIsWorker = true;
    const MemoryLimit limit;
    if (options.sandbox) limit.setForever(memory);
    if (options.sandbox && !enterSandbox(*options.sandbox, std::array{requests, answers}).empty()) ::_exit(1);
    std::uint64_t index = 0;
    while (receiveAll(requests, std::as_writable_bytes(std::span(&index, 1)))) {
        if (index >= count) ::_exit(1);  // something else has written into the pipe
        limit.set(memoryOf(options, index));
        thisStep.seconds = secondsOf(options, index);
        thisStep.start = Clock::now();
        try {
            const std::string answer = work(index, [answers](const std::string& text) {
                send(answers, MessageKind::step, text);
                thisStep.start = Clock::now();
            });
            send(answers, MessageKind::answer, answer);
        } catch (const DeviceLost& lost) {
            send(answers, MessageKind::deviceLost, toText(lost));
            break;
        }
    }
    std::fflush(nullptr);
    ::_exit(0);
}

/// Bytes that a process has written, by calls or through mapped files; 0 if the system does not tell.
std::uint64_t writtenBy(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/io");
    std::uint64_t written = 0, value = 0;
    for (std::string key; file >> key >> value;)
        if (key == "wchar:" || key == "write_bytes:") written = std::max(written, value);
    return written;
}

/// Ticks that the system has worked for a process, as for each file that it makes; 0 if it does not tell.
std::uint64_t systemTimeOf(pid_t process) {
    constexpr int kBefore = 12;  // fields between the name and this one (proc(5))
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string field;
    std::getline(file, field, ')');
    for (int i = 0; i < kBefore; ++i) file >> field;
    std::uint64_t ticks = 0;
    file >> ticks;
    return ticks;
}

/// Files and folders that confined processes may make in all, for each piece, and more after one was ended
/// for that.
constexpr std::uint64_t kMostMade = 250'000, kMostMadeForPiece = 256, kMostMadeAgain = 20'000;

/// The number of files and folders below those that confined processes may write to, as far as `most`. A
/// folder that cannot be listed may hold any number.
std::uint64_t filesBelow(const Sandbox& sandbox, std::uint64_t most) {
    namespace fs = std::filesystem;
    std::uint64_t count = 0;
    std::vector<fs::path> open;
    for (const Reach& each : sandbox.writable) open.push_back(each.whole());
    while (!open.empty() && count <= most) {
        std::error_code failure;
        fs::directory_iterator each(open.back(), failure);
        open.pop_back();
        for (; !failure && each != fs::directory_iterator() && count <= most; each.increment(failure)) {
            ++count;
            std::error_code gone;
            if (each->symlink_status(gone).type() == fs::file_type::directory) open.push_back(each->path());
        }
        if (failure && failure != std::errc::no_such_file_or_directory) count += kMostMade;
    }
    return count;
}

struct Worker {
    pid_t process = -1;
    int requests = -1;          ///< we write
    int answers = -1;           ///< we read
    std::uint64_t memory = 0;   ///< that it may take
    std::uint64_t written = 0;  ///< bytes, before its piece; of a confined one
    std::uint64_t worked = 0;   ///< systemTimeOf() before its piece; likewise
    std::string received;       ///< of its answers, not yet a whole message
    std::optional<std::size_t> piece;
    bool isAlone = false;  ///< no other worker has had a piece since this one began its own
    Clock::time_point deadline = Clock::time_point::max();
};

std::optional<Worker> start(std::size_t count, const WorkerOptions& options, const Work& work,
                            const std::vector<Worker>& others, std::uint64_t memory) {
    std::array<int, 2> requests{};
    std::array<int, 2> answers{};
    if (::pipe(requests.data()) != 0) return std::nullopt;
    if (::pipe(answers.data()) != 0) {
        ::close(requests[0]);
        ::close(requests[1]);
        return std::nullopt;
    }
    std::fflush(nullptr);
    const pid_t process = ::fork();
    if (process == 0) {
        // Close the other workers' pipes: open ends here would hide from the parent that a worker died.
        for (const Worker& other : others) {
            if (other.requests >= 0) ::close(other.requests);
            if (other.answers >= 0) ::close(other.answers);
        }
        ::close(requests[1]);
        ::close(answers[0]);
        servePieces(requests[0], answers[1], count, options, work, memory);
    }
    ::close(requests[0]);
    ::close(answers[1]);
    if (process < 0) {
        ::close(requests[1]);
        ::close(answers[0]);
        return std::nullopt;
    }
    Worker worker;
    worker.process = process;
    worker.requests = requests[1];
    worker.answers = answers[0];
    worker.memory = memory;
    return worker;
}

struct Ended {
    int signal = 0;  ///< that ended the worker, or 0
    std::uint64_t peakMemory = 0;
};

/// Closes the pipes and waits.
Ended finish(Worker& worker) {
    if (worker.requests >= 0) ::close(worker.requests);
    if (worker.answers >= 0) ::close(worker.answers);
    int status = 0;
    rusage usage{};
    if (worker.process > 0)
        while (::wait4(worker.process, &status, 0, &usage) < 0 && errno == EINTR) {
        }
    worker = Worker{};
    constexpr std::uint64_t kUnit = 1024;  // of ru_maxrss
    return {WIFSIGNALED(status) ? WTERMSIG(status) : 0, static_cast<std::uint64_t>(usage.ru_maxrss) * kUnit};
}

class Pool {
  public:
    Pool(std::size_t count, const WorkerOptions& options, const Work& work,
         const std::function<void(std::size_t, const Outcome&)>& done,
         const std::function<void(std::size_t, const std::string&)>& progress)
        : count_(count), options_(options), work_(work), done_(done), progress_(progress) {
        if (options.sandbox)
            mostFiles_ = filesBelow(*options.sandbox, kUnlimited) + kMostMade + kMostMadeForPiece * count;
    }

    void run() {
        const auto wanted = static_cast<std::size_t>(std::max(1, options_.workers));
        workers_.resize(std::min(wanted, count_));
        // A worker that dies during this write is detected when its pipe is read.
        struct sigaction ignore{};
        struct sigaction before{};
        ignore.sa_handler = SIG_IGN;
        ::sigaction(SIGPIPE, &ignore, &before);
        while (next_ < count_ || !again_.empty() || busy() > 0) {
            if (options_.stop && options_.stop()) {
                for (Worker& worker : workers_)
                    if (worker.piece) end(worker, {.end = Outcome::End::stopped});
                break;
            }
            for (Worker& worker : workers_) {
                if (worker.piece) continue;
                if (next_ < count_)
                    give(worker, next_);
                else if (!again_.empty() && busy() == 0)
                    give(worker, again_.front());
            }
            if (busy() > 0) waitForNews();
        }
        for (Worker& worker : workers_) dismiss(worker);
        ::sigaction(SIGPIPE, &before, nullptr);
    }

  private:
    [[nodiscard]] std::size_t busy() const {
        return static_cast<std::size_t>(std::count_if(
            workers_.begin(), workers_.end(), [](const Worker& each) { return each.piece.has_value(); }));
    }

    /// Ends a worker that has no piece.
    void dismiss(Worker& worker) const {
        // One that has been taken over may not end by itself.
        if (options_.sandbox && worker.process > 0) ::kill(worker.process, SIGKILL);
        finish(worker);
    }

    void beginStep(Worker& worker) const {
        const double seconds =
            options_.timeLeft ? options_.timeLeft(*worker.piece) : secondsOf(options_, *worker.piece);
        worker.deadline = seconds > 0 ? Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                           std::chrono::duration<double>(seconds))
                                      : Clock::time_point::max();
    }

    /// Gives the first piece that waits: `piece` is that of next_ or of again_.
    void give(Worker& worker, std::size_t piece) {
        const bool isRepeated = piece != next_;
        const std::uint64_t memory = memoryOf(options_, piece);
        // What a worker has opened on the device may be lost like that of the one before. The limit of memory
        // of a confined worker cannot be raised.
        if (isRepeated || (options_.sandbox && worker.process >= 0 && worker.memory != memory))
            dismiss(worker);
        if (worker.process < 0) {
            std::optional<Worker> started = start(count_, options_, work_, workers_, memory);
            if (!started && busy() > 0) return;  // try again when another worker is done
            if (started) worker = *started;
        }
        if (isRepeated)
            again_.pop_front();
        else
            ++next_;
        if (worker.process < 0) return done_(piece, {.end = Outcome::End::crashed});
        worker.received.clear();
        worker.isAlone = busy() == 0;
        for (Worker& other : workers_)
            if (other.piece) other.isAlone = false;
        worker.piece = piece;
        if (options_.sandbox) {
            worker.written = writtenBy(worker.process);
            worker.worked = systemTimeOf(worker.process);
        }
        const std::uint64_t index = piece;
        writeAll(worker.requests, std::as_bytes(std::span(&index, 1)));
        beginStep(worker);
    }

    void end(Worker& worker, Outcome outcome) {
        const std::size_t piece = *worker.piece;
        outcome.process = worker.process;
        outcome.wasAlone = worker.isAlone;
        if (outcome.end != Outcome::End::crashed) ::kill(worker.process, SIGKILL);
        const Ended ended = finish(worker);
        if (outcome.end == Outcome::End::crashed) {
            outcome.signal = ended.signal;
            const std::uint64_t memory = memoryOf(options_, piece);
            outcome.nearMemoryLimit = memory > 0 && ended.peakMemory > memory / 2;
        }
        if (outcome.end == Outcome::End::deviceLost && options_.sharesDevice)
            for (Worker& other : workers_)
                if (other.piece) beginStep(other);
        if (options_.repeats && mayBeInnocent(outcome, options_.sharesDevice, times_[piece])) {
            ++times_[piece];
            again_.push_back(piece);
            if (options_.repeated) options_.repeated(piece, outcome);
            return;
        }
        done_(piece, outcome);
    }

    /// Reads what there is. It never waits for the rest of a message, since a worker may stop in its middle.
    void receive(Worker& worker) {
        constexpr std::size_t kPortion = 1U << 16U;
        const std::size_t had = worker.received.size();
        worker.received.resize(had + kPortion);
        const ssize_t got = ::read(worker.answers, worker.received.data() + had, kPortion);
        worker.received.resize(had + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
        if (got < 0 && errno == EINTR) return;
        if (got <= 0) return end(worker, {.end = Outcome::End::crashed});
        while (worker.piece && takeMessage(worker)) {
        }
    }

    /// For a worker that has been taken over by what it reads.
    void endAsCrashed(Worker& worker) {
        ::kill(worker.process, SIGKILL);
        end(worker, {.end = Outcome::End::crashed});
    }

    /// Takes the first message of what was received. False if it is not whole.
    bool takeMessage(Worker& worker) {
        Header header;
        if (worker.received.size() < sizeof header) return false;
        std::memcpy(&header, worker.received.data(), sizeof header);
        const bool isStep = header.kind == MessageKind::step;
        const bool isLost = header.kind == MessageKind::deviceLost;
        if ((!isStep && !isLost && header.kind != MessageKind::answer) || header.bytes > kLargestMessage) {
            endAsCrashed(worker);
            return false;
        }
        if (worker.received.size() - sizeof header < header.bytes) return false;
        std::string text = worker.received.substr(sizeof header, header.bytes);
        worker.received.erase(0, sizeof header + header.bytes);
        if (isStep) {
            progress_(*worker.piece, text);
            beginStep(worker);
        } else if (isLost) {
            std::optional<DeviceLost> lost = parseDeviceLost(text);
            if (!lost)
                endAsCrashed(worker);
            else
                end(worker, {.end = Outcome::End::deviceLost, .lost = std::move(*lost)});
            return false;
        } else {
            const std::size_t piece = *worker.piece;
            worker.piece.reset();
            done_(piece, {.answer = std::move(text)});
        }
        return true;
    }

    void waitForNews() {
        std::vector<pollfd> files;
        std::vector<std::size_t> owners;
        Clock::time_point first = Clock::time_point::max();
        for (std::size_t i = 0; i < workers_.size(); ++i) {
            if (!workers_[i].piece) continue;
            files.push_back({workers_[i].answers, POLLIN, 0});
            owners.push_back(i);
            first = std::min(first, workers_[i].deadline);
        }
        int milliseconds = -1;
        if (first != Clock::time_point::max()) {
            const auto left =
                std::chrono::duration_cast<std::chrono::milliseconds>(first - Clock::now()).count() + 1;
            milliseconds = static_cast<int>(std::clamp<std::int64_t>(left, 0, 1'000'000));
        }
        constexpr int kBetweenQuestions = 200;
        if ((options_.stop || options_.sandbox) && (milliseconds < 0 || milliseconds > kBetweenQuestions))
            milliseconds = kBetweenQuestions;
        if (::poll(files.data(), files.size(), milliseconds) < 0) return;
        for (std::size_t i = 0; i < files.size(); ++i) {
            Worker& worker = workers_[owners[i]];
            if (files[i].revents != 0)
                receive(worker);
            else if (Clock::now() >= worker.deadline)
                end(worker, {.end = Outcome::End::timedOut});
            else if (options_.sandbox && writtenBy(worker.process) > worker.written + kMostWritten)
                endAsCrashed(worker);
        }
        if (options_.sandbox && Clock::now() >= nextCount_) endMaker();
    }

    /// Ends the worker for which the system has worked most in its piece if there are too many files: it is
    /// the one that has made them.
    void endMaker() {
        constexpr int kPause = 20;  // times as long as counting takes
        const Clock::time_point begin = Clock::now();
        const std::uint64_t count = filesBelow(*options_.sandbox, mostFiles_);
        nextCount_ = Clock::now() + kPause * (Clock::now() - begin);
        if (count <= mostFiles_) return;
        Worker* most = nullptr;
        std::uint64_t ticks = 0;
        for (Worker& each : workers_) {
            if (!each.piece) continue;
            const std::uint64_t own = systemTimeOf(each.process) - each.worked;
            if (most != nullptr && own <= ticks) continue;
            most = &each;
            ticks = own;
        }
        if (most == nullptr) return;
        endAsCrashed(*most);
        mostFiles_ = filesBelow(*options_.sandbox, kUnlimited) + kMostMadeAgain;
    }

    static constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

    std::size_t count_;
    const WorkerOptions& options_;
    const Work& work_;
    const std::function<void(std::size_t, const Outcome&)>& done_;
    const std::function<void(std::size_t, const std::string&)>& progress_;
    std::vector<Worker> workers_;
    std::size_t next_ = 0;
    std::deque<std::size_t> again_;     ///< pieces to be done again, each alone
    std::map<std::size_t, int> times_;  ///< how often that was so
    std::uint64_t mostFiles_ = 0;       ///< below the folders that confined workers may write to
    Clock::time_point nextCount_{};     ///< of these files
};

}  // namespace

bool mayBeInnocent(const Outcome& outcome, bool sharesDevice, int times) {
    constexpr int kMostTimes = 3;  // other programs may go on and on
    if (outcome.end == Outcome::End::timedOut) return sharesDevice && !outcome.wasAlone && times == 0;
    if (outcome.end != Outcome::End::deviceLost || outcome.lost.cause == ResetCause::own) return false;
    if (outcome.lost.cause == ResetCause::unknown && outcome.wasAlone) return false;
    return times < kMostTimes;
}

bool isWorker() {
    return thisProcessIsWorker;
}

std::optional<StepTime> stepTime() {
    if (!thisProcessIsWorker || thisStep.seconds <= 0) return std::nullopt;
    const double passed = std::chrono::duration<double>(Clock::now() - thisStep.start.load()).count();
    return StepTime{thisStep.seconds, std::max(0., thisStep.seconds - passed)};
}

void runInWorkers(std::size_t count, const WorkerOptions& options, const Work& work,
                  const std::function<void(std::size_t, const Outcome&)>& done,
                  const std::function<void(std::size_t, const std::string&)>& progress) {
    Pool(count, options, work, done, progress).run();
}

}  // namespace glibra::base
