#include "base/workers.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstring>
#include <deque>
#include <filesystem>
#include <limits>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

#include "base/hash.h"
#include "base/packed.h"
#include "system/child_process.h"
#include "system/memory.h"

namespace glibra::base {

void eachMember(auto& packed, Is<WorkerEvent> auto& of) {
    packed.upTo(WorkerEvent::Kind::done, of.kind);
    packed.upTo(Outcome::End::deviceLost, of.outcome.end);
    packed(of.index, of.outcome.signal, of.outcome.process, of.outcome.nearMemoryLimit, of.outcome.wasAlone,
           of.outcome.answer, of.outcome.lost, of.text);
}

namespace {

/// More than all answers of a class of a thousand.
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30U;

}  // namespace

std::uint64_t numberOfCall(std::string_view place, std::size_t times) {
    return combined(fnv1a(place), times);
}

std::string toBytes(const WorkerCalls& calls) {
    return packed(packed(calls));
}

WorkerCalls receiveCalls(const system::File& pipe) {
    std::uint64_t size = 0;
    if (!receiveAll(pipe, std::as_writable_bytes(std::span(&size, 1))) || size > kMostBytes) return {};
    std::string bytes(size, '\0');
    if (!receiveAll(pipe, std::as_writable_bytes(std::span(bytes)))) return {};
    return unpacked<WorkerCalls>(bytes).value_or(WorkerCalls());
}

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

void send(const system::File& file, MessageKind kind, const std::string& text) {
    const Header header{kind, static_cast<std::uint32_t>(text.size())};
    if (writeAll(file, std::as_bytes(std::span(&header, 1))) != 0 || writeAll(file, text) != 0)
        system::endWorker(1);
}

/// The worker's main loop: reads pieces and writes answers until the parent closes the pipe.
/// In a sandbox, its limit of memory is one that nothing in the worker can raise.
[[noreturn]] void servePieces(const system::WorkerEnds& ends, std::size_t count, const WorkerOptions& options,
                              const Work& work) {
    system::becomeWorker();
    thisProcessIsWorker = true;
    const system::MemoryLimit limit;
    if (options.sandbox) limit.setForever(ends.memory);
    if (options.sandbox &&
        !system::enterSandbox(*options.sandbox, std::array{&ends.requests, &ends.answers}).empty())
        system::endWorker(1);
    std::uint64_t index = 0;
    while (receiveAll(ends.requests, std::as_writable_bytes(std::span(&index, 1)))) {
        if (index >= count) system::endWorker(1);  // something else has written into the pipe
        limit.set(memoryOf(options, index));
        thisStep.seconds = secondsOf(options, index);
        thisStep.start = Clock::now();
        try {
            const std::string answer = work(index, [&ends](const std::string& text) {
                send(ends.answers, MessageKind::step, text);
                thisStep.start = Clock::now();
            });
            send(ends.answers, MessageKind::answer, answer);
        } catch (const DeviceLost& lost) {
            send(ends.answers, MessageKind::deviceLost, packed(lost));
            break;
        }
    }
    system::endWorker(0);
}

/// Files and folders that confined processes may make in all, for each piece, and more after one was ended
/// for that.
constexpr std::uint64_t kMostMade = 250'000, kMostMadeForPiece = 256, kMostMadeAgain = 20'000;

/// The number of files and folders below those that confined processes may write to, as far as `most`. A
/// folder that cannot be listed may hold any number.
std::uint64_t filesBelow(const system::Sandbox& sandbox, std::uint64_t most) {
    namespace fs = std::filesystem;
    std::uint64_t count = 0;
    std::vector<fs::path> open;
    for (const system::Reach& each : sandbox.writable) open.push_back(each.whole());
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
    system::Worker process{};   ///< empty: none
    std::uint64_t memory = 0;   ///< that it may take
    std::uint64_t written = 0;  ///< bytes, before its piece; of a confined one
    std::uint64_t worked = 0;   ///< system::systemWorkFor() before its piece; likewise
    std::string received{};     ///< of its answers, not yet a whole message
    std::optional<std::size_t> piece{};
    bool isAlone = false;  ///< no other worker has had a piece since this one began its own
    bool isStale = false;  ///< the device has been reset: what it opened there before may be lost
    Clock::time_point deadline = Clock::time_point::max();

    [[nodiscard]] bool isRunning() const { return static_cast<bool>(process.process); }
};

/// Waits for its end, after which the worker is as new.
system::End finish(Worker& worker) {
    const system::End end = system::end(worker.process);
    worker = Worker{};
    return end;
}

/// How a worker that is this program started again comes to the call.
struct WayToCall {
    std::uint64_t call = 0;
    std::string before{};  ///< what it is sent first: toBytes() of the calls before
};

class Pool {
  public:
    Pool(std::size_t count, const WorkerOptions& options, const Work& work,
         const std::function<void(std::size_t, const Outcome&)>& done,
         const std::function<void(std::size_t, const std::string&)>& progress, WayToCall way)
        : count_(count),
          options_(options),
          work_(work),
          done_(done),
          progress_(progress),
          way_(std::move(way)) {
        if (options.sandbox)
            mostFiles_ = filesBelow(*options.sandbox, kUnlimited) + kMostMade + kMostMadeForPiece * count;
    }

    void run() {
        const auto wanted = static_cast<std::size_t>(std::max(1, options_.workers));
        workers_.resize(std::min(wanted, count_));
        // A worker that dies during a write is detected when its pipe is read.
        const system::BrokenPipesAreErrors errors;
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
    }

  private:
    [[nodiscard]] std::size_t busy() const {
        return static_cast<std::size_t>(std::count_if(
            workers_.begin(), workers_.end(), [](const Worker& each) { return each.piece.has_value(); }));
    }

    [[nodiscard]] std::vector<system::Worker*> all() {
        std::vector<system::Worker*> processes;
        for (Worker& each : workers_) processes.push_back(&each.process);
        return processes;
    }

    /// Ends a worker that has no piece.
    void dismiss(Worker& worker) const {
        // One that has been taken over may not end by itself.
        if (options_.sandbox) kill(worker.process.process);
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
        if (isRepeated || worker.isStale ||
            (options_.sandbox && worker.isRunning() && worker.memory != memory))
            dismiss(worker);
        if (!worker.isRunning()) {
            std::optional<system::Worker> started = system::startWorker(
                all(), memory, way_.call,
                [&](const system::WorkerEnds& ends) { servePieces(ends, count_, options_, work_); });
            if (!started && busy() > 0) return;  // try again when another worker is done
            if (started) worker = {.process = std::move(*started), .memory = memory};
            if (started && !way_.before.empty()) send(worker.process, std::as_bytes(std::span(way_.before)));
        }
        if (isRepeated)
            again_.pop_front();
        else
            ++next_;
        if (!worker.isRunning()) return done_(piece, {.end = Outcome::End::crashed});
        worker.received.clear();
        worker.isAlone = busy() == 0;
        for (Worker& other : workers_)
            if (other.piece) other.isAlone = false;
        worker.piece = piece;
        if (options_.sandbox) {
            worker.written = bytesWrittenBy(worker.process.process);
            worker.worked = systemWorkFor(worker.process.process);
        }
        const std::uint64_t index = piece;
        send(worker.process, std::as_bytes(std::span(&index, 1)));
        beginStep(worker);
    }

    void end(Worker& worker, Outcome outcome) {
        const std::size_t piece = *worker.piece;
        outcome.process = worker.process.process.number();
        outcome.wasAlone = worker.isAlone;
        if (outcome.end != Outcome::End::crashed) kill(worker.process.process);
        const system::End ended = finish(worker);
        if (outcome.end == Outcome::End::crashed) {
            outcome.signal = ended.signal;
            const std::uint64_t memory = memoryOf(options_, piece);
            outcome.nearMemoryLimit = memory > 0 && ended.peakMemory > memory / 2;
        }
        if (outcome.end == Outcome::End::deviceLost)
            for (Worker& other : workers_) {
                other.isStale = other.isRunning();
                if (other.piece && options_.sharesDevice) beginStep(other);
            }
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
        const system::Received received = system::receive(worker.process, worker.received);
        if (received == system::Received::interrupted) return;
        if (received == system::Received::ended) return end(worker, {.end = Outcome::End::crashed});
        while (worker.piece && takeMessage(worker)) {
        }
    }

    /// For a worker that has been taken over by what it reads.
    void endAsCrashed(Worker& worker) {
        kill(worker.process.process);
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
            std::optional<DeviceLost> lost = unpacked<DeviceLost>(text);
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
        std::vector<system::Worker*> waiting;
        std::vector<std::size_t> owners;
        Clock::time_point first = Clock::time_point::max();
        for (std::size_t i = 0; i < workers_.size(); ++i) {
            if (!workers_[i].piece) continue;
            waiting.push_back(&workers_[i].process);
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
        const auto ready = std::make_unique<bool[]>(waiting.size());
        const std::span<bool> isReady(ready.get(), waiting.size());
        if (!waitForAny(waiting, milliseconds, isReady)) return;
        for (std::size_t i = 0; i < waiting.size(); ++i) {
            Worker& worker = workers_[owners[i]];
            if (isReady[i])
                receive(worker);
            else if (Clock::now() >= worker.deadline)
                end(worker, {.end = Outcome::End::timedOut});
            else if (options_.sandbox &&
                     bytesWrittenBy(worker.process.process) > worker.written + system::kMostWritten)
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
            const std::uint64_t own = systemWorkFor(each.process.process) - each.worked;
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
    WayToCall way_;
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

namespace {

using Done = std::function<void(std::size_t, const Outcome&)>;
using Progress = std::function<void(std::size_t, const std::string&)>;

/// The calls of this process, where workers are no copies.
struct Calls {
    std::map<std::string, std::size_t> passed{};  ///< by place
    WorkerCalls made{};                           ///< that of the parent, in a worker
    std::optional<system::WorkerEnds> ends = system::endsOfThisWorker();

    Calls() {
        if (ends) made = receiveCalls(ends->requests);
    }
};

void repeat(const std::vector<WorkerEvent>& events, const WorkerOptions& options, const Done& done,
            const Progress& progress) {
    for (const WorkerEvent& each : events) {
        if (each.kind == WorkerEvent::Kind::progress)
            progress(each.index, each.text);
        else if (each.kind == WorkerEvent::Kind::done)
            done(each.index, each.outcome);
        else if (options.repeated)
            options.repeated(each.index, each.outcome);
    }
}

/// Comes to the same state as the parent, or serves it.
void runStartedAgain(std::size_t count, const WorkerOptions& options, const Work& work, const Done& done,
                     const Progress& progress, const std::string& place) {
    static Calls calls;
    const std::uint64_t call = numberOfCall(place, calls.passed[place]++);
    if (calls.ends) {
        if (call == calls.ends->call) servePieces(*calls.ends, count, options, work);
        return repeat(calls.made[call], options, done, progress);
    }
    std::vector<WorkerEvent> events;
    WorkerOptions noting = options;
    noting.repeated = [&](std::size_t index, const Outcome& outcome) {
        events.push_back({WorkerEvent::Kind::repeated, index, outcome});
        if (options.repeated) options.repeated(index, outcome);
    };
    const Done noteDone = [&](std::size_t index, const Outcome& outcome) {
        events.push_back({WorkerEvent::Kind::done, index, outcome});
        done(index, outcome);
    };
    const Progress noteProgress = [&](std::size_t index, const std::string& text) {
        events.push_back({.index = index, .text = text});
        progress(index, text);
    };
    Pool(count, noting, work, noteDone, noteProgress, {call, toBytes(calls.made)}).run();
    calls.made[call] = std::move(events);
}

}  // namespace

void runInWorkers(std::size_t count, const WorkerOptions& options, const Work& work, const Done& done,
                  const Progress& progress, const std::source_location& place) {
    if (system::workersAreCopies()) return Pool(count, options, work, done, progress, {}).run();
    runStartedAgain(count, options, work, done, progress,
                    std::string(place.file_name()) + ":" + std::to_string(place.line()));
}

}  // namespace glibra::base
