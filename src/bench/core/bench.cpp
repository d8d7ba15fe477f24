#include "bench/core/bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <span>

#include "system/child_process.h"
#include "system/interruption.h"
#include "system/library.h"
#include "system/places.h"

namespace glibra::bench {
namespace {

/// Precedes each text. Functions have the same addresses in a forked process.
struct Head {
    Apart::Work work = nullptr;  ///< requests only; null ends the process
    bool isAnswered = false;     ///< answers only; otherwise the text says why there is none
    std::size_t size = 0;
};

bool send(const system::File& file, Head head, const std::string& text) {
    head.size = text.size();
    return writeAll(file, std::as_bytes(std::span(&head, 1))) == 0 && writeAll(file, text) == 0;
}

bool receive(const system::File& file, Head& head, std::string& text) {
    if (!receiveAll(file, std::as_writable_bytes(std::span(&head, 1)))) return false;
    text.resize(head.size);
    return receiveAll(file, std::as_writable_bytes(std::span(text)));
}

/// Runs one piece of work in a new process, so that the next one finds no driver loaded.
void answerOnce(const system::File& answers, const Head& request, const std::string& text) {
    system::Process copy =
        system::runInCopy([&] { send(answers, {.isAnswered = true}, request.work(text)); });
    if (!copy) {
        send(answers, {}, std::string("cannot be started: ") + std::strerror(errno));
        return;
    }
    const system::End end = waitFor(copy);
    if (end.signal != 0)
        send(answers, {}, fmt::format("ended by signal {} ({})", end.signal, system::signalText(end.signal)));
    else if (end.status != 0)
        send(answers, {}, fmt::format("ended with status {}", end.status));
}

void serve(const system::File& requests, const system::File& answers) {
    // If the parent ends, the closed pipes end this loop.
    const system::BrokenPipesAreErrors errors;
    Head request;
    std::string text;
    while (receive(requests, request, text) && request.work) answerOnce(answers, request, text);
}

using Clock = std::chrono::steady_clock;

constexpr double kShortest = 20e-6;  ///< seconds; shorter work is repeated inside one measurement
constexpr int kMostTimes = 1 << 20;  ///< repeats inside one measurement, even where a clock stands still
constexpr double kLong = .25;        ///< seconds; for work this long, warming up does not matter
constexpr int kFewestRepeats = 5, kMostRepeats = 101, kQuickRepeats = 3;

/// Linear interpolation between the closest ranks; `sorted` is not empty.
double percentile(const std::vector<double>& sorted, double fraction) {
    const double place = fraction * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

constexpr double kShortestRun = 10e-3;  ///< seconds; shorter work is repeated inside one measurement
constexpr int kMostInner = 10'000;

double now(bool byProcessor) {
    if (byProcessor) return system::processorSeconds();
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

double secondsEach(const std::function<void()>& work, int inner, bool byProcessor) {
    const double start = now(byProcessor);
    for (int i = 0; i < inner; ++i) work();
    return (now(byProcessor) - start) / inner;
}

/// How often the work is repeated inside one measurement. Runs it to warm up.
int innerOf(const std::function<void()>& work, bool byProcessor) {
    work();
    const double once = secondsEach(work, 1, byProcessor);
    return static_cast<int>(
        std::clamp(std::ceil(kShortestRun / std::max(once, 1e-9)), 1., double{kMostInner}));
}

}  // namespace

Apart::Apart() {
    if (!system::hasOneThread() || system::isLibraryLoaded({"libEGL", "OSMesa"})) return;
    system::File requests, answers;
    if (makePipe(requests, requests_) != 0 || makePipe(answers_, answers) != 0) return;
    process_ = system::runInCopy([&] {
        requests_.close();
        answers_.close();
        serve(requests, answers);
    });
}

Apart::~Apart() {
    if (!process_) return;
    // Closing the pipe is not enough: processes forked since then hold it open too.
    send(requests_, {}, {});
    requests_.close();
    answers_.close();
    waitFor(process_);
}

std::optional<std::string> Apart::run(Work work, const std::string& request) {
    if (!process_) return std::nullopt;
    Head answer;
    std::string text;
    if (!send(requests_, {.work = work}, request) || !receive(answers_, answer, text)) {
        failure_ = "gave no answer";
        return std::nullopt;
    }
    failure_ = answer.isAnswered ? std::string() : text;
    return answer.isAnswered ? std::optional(std::move(text)) : std::nullopt;
}

Timing timingOf(std::vector<double> seconds) {
    std::ranges::sort(seconds);
    return {.median = percentile(seconds, .5),
            .low = percentile(seconds, .25),
            .high = percentile(seconds, .75),
            .repeats = static_cast<int>(seconds.size())};
}

Timing timingBy(const std::function<double(int times)>& measure, bool quick, double enough) {
    const double first = measure(1);
    int inner = 1;
    double last = measure(inner);
    const bool isLong = std::min(first, last) > kLong;
    while (last < kShortest && inner < kMostTimes) {
        const double each = std::max(last / inner, 1e-9);
        inner = std::min(std::max(2 * inner, static_cast<int>(std::ceil(kShortest / each))), kMostTimes);
        last = measure(inner);
    }
    std::vector<double> taken{last / inner};
    if (isLong) taken.push_back(first);
    double total = last;
    const int fewest = quick || isLong ? kQuickRepeats : kFewestRepeats;
    const int most = quick || isLong ? kQuickRepeats : kMostRepeats;
    while (static_cast<int>(taken.size()) < fewest ||
           (static_cast<int>(taken.size()) < most && total < enough)) {
        last = measure(inner);
        taken.push_back(last / inner);
        total += last;
    }
    return timingOf(std::move(taken));
}

PairedTiming timePairs(const std::function<void()>& first, const std::function<void()>& second, int pairs,
                       bool byProcessor) {
    const int innerFirst = innerOf(first, byProcessor), innerSecond = innerOf(second, byProcessor);
    std::vector<double> firsts, seconds, ratios;
    for (int i = 0; i < pairs; ++i) {
        // Each goes first in turn, so that what grows with time favours neither.
        if (i % 2 == 0) firsts.push_back(secondsEach(first, innerFirst, byProcessor));
        seconds.push_back(secondsEach(second, innerSecond, byProcessor));
        if (i % 2 == 1) firsts.push_back(secondsEach(first, innerFirst, byProcessor));
        ratios.push_back(firsts.back() / std::max(seconds.back(), 1e-12));
    }
    return {timingOf(std::move(firsts)), timingOf(std::move(seconds)), timingOf(std::move(ratios))};
}

std::string verdict(const Timing& ratio, bool mayBeEqual) {
    constexpr double kNoDifference = .03;  // ratios within this of 1
    const std::string range = fmt::format("{:.2f} ({:.2f} .. {:.2f})", ratio.median, ratio.low, ratio.high);
    if (ratio.low > 1 + kNoDifference) return "true here, by " + range;
    if (ratio.high < 1 - kNoDifference)
        return fmt::format("false here: the ratio is {}, so the other way is faster by {:.2f}", range,
                           1 / ratio.median);
    return fmt::format("{}: no difference here, the ratio is {}", mayBeEqual ? "true here" : "false here",
                       range);
}

struct Bench::State {
    Apart apart;  // before anything that loads a driver
    BenchOptions options;
    std::optional<gpu::Context> context;
    Diagnostics problems;
};

Bench::Bench(const BenchOptions& options) : state_(std::make_unique<State>()) {
    state_->options = options;
}
Bench::~Bench() = default;

const BenchOptions& Bench::options() const {
    return state_->options;
}

gpu::Context& Bench::context() {
    if (!state_->context) {
        const BenchOptions& options = state_->options;
        if (options.filtersInBytes) system::removeVariable("GALLIVM_PERF");
        state_->context.emplace(
            need(gpu::openContext({.driver = options.driver, .floatFiltering = !options.filtersInBytes})));
    }
    return *state_->context;
}

Timing Bench::time(const std::function<void()>& work, double enough) const {
    const auto measure = [&](int times) {
        const Clock::time_point start = Clock::now();
        for (int i = 0; i < times; ++i) work();
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    return timingBy(measure, isQuick(), enough);
}

Timing Bench::timeDrawing(const std::function<void()>& draw) const {
    return time([&draw] {
        draw();
        glFinish();
    });
}

void Bench::attempt(const std::function<void()>& work) {
    try {
        work();
    } catch (const Failed& failed) {
        report(failed.diagnostics);
    }
}

void Bench::report(const Diagnostics& diagnostics) {
    Diagnostics& known = state_->problems;
    for (const Diagnostic& each : diagnostics)
        if (std::ranges::find(known, each.text, &Diagnostic::text) == known.end()) known.push_back(each);
}

const Diagnostics& Bench::problems() const {
    return state_->problems;
}

Apart& Bench::apart() {
    return state_->apart;
}

}  // namespace glibra::bench
