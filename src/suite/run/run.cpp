#include "suite/run/run.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>
#include <utility>

#include "base/contained_call.h"
#include "base/text.h"
#include "base/workers.h"
#include "gpu/context/context.h"
#include "image/file.h"
#include "suite/golden/hash_list.h"
#include "suite/run/shot_renderer.h"
#include "suite/run/verdict.h"
#include "system/interruption.h"

namespace glibra::suite {

std::vector<std::vector<std::size_t>> planPieces(std::size_t count, int workers,
                                                 const std::function<bool(std::size_t)>& joins) {
    // Guided self-scheduling (Polychronopoulos and Kuck, 1987): each piece is a share of what remains.
    constexpr std::size_t kLongest = 16;
    constexpr std::size_t kShares = 3;
    const std::size_t share = kShares * static_cast<std::size_t>(std::max(1, workers));
    const bool isShared = workers > 1;
    std::vector<std::vector<std::size_t>> pieces;
    for (std::size_t next = 0; next < count;) {
        const std::size_t size =
            isShared ? std::clamp<std::size_t>((count - next) / share, 1, kLongest) : count - next;
        std::vector<std::size_t>& piece = pieces.emplace_back();
        do piece.push_back(next++);
        while (next < count && piece.size() < size && joins(next));
    }
    return pieces;
}

bool ShotClocks::mayRestart(const ShotReference& shot) {
    // A shot begins and is judged, perhaps twice each, and others wait for it and go on with it.
    constexpr int kMostRestarts = 32;
    return ++restarts_[shot] <= kMostRestarts;
}

void ShotClocks::hear(const Begins& begins, Clock::time_point now) {
    if (mayRestart(begins.shot)) drawing_ = {begins.shot, now};
}

void ShotClocks::hear(const Phase& phase, Clock::time_point now) {
    switch (phase.kind) {
        case Phase::Kind::awaits:
            if (drawing_ && drawing_->shot == phase.shot) return;
            if (mayRestart(phase.shot)) drawing_ = {phase.shot, now};
            return;
        case Phase::Kind::drawn:
            if (drawing_ && drawing_->shot == phase.shot) drawing_.reset();
            return;
        case Phase::Kind::judges:
            if (mayRestart(phase.shot)) judging_ = {phase.shot, now};
            return;
        case Phase::Kind::recalls:
            if (judging_ && judging_->shot == phase.shot) judging_.reset();
            return;
    }
}

void ShotClocks::hear(const Done& done) {
    for (std::optional<Running>* each : {&drawing_, &judging_})
        if (*each && (*each)->shot == done.shot) each->reset();
}

std::optional<ShotClocks::Clock::time_point> ShotClocks::endOf(const std::optional<Running>& running) const {
    if (!running) return std::nullopt;
    const double seconds = (*limitOf_)(running->shot);
    if (seconds <= 0) return std::nullopt;
    return running->since +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

std::optional<double> ShotClocks::left(Clock::time_point now) const {
    if (!drawing_ && !judging_) return std::nullopt;
    std::optional<double> least;
    for (const auto* each : {&drawing_, &judging_})
        if (const std::optional<Clock::time_point> end = endOf(*each)) {
            const double seconds = std::max(std::chrono::duration<double>(*end - now).count(), 1e-3);
            least = std::min(least.value_or(seconds), seconds);
        }
    return least.value_or(0);
}

std::optional<ShotReference> ShotClocks::latest() const {
    const auto drawn = endOf(drawing_), judged = endOf(judging_);
    if (judged && (!drawn || *judged < *drawn)) return judging_->shot;
    if (drawn) return drawing_->shot;
    return std::nullopt;
}

std::optional<ShotReference> ShotClocks::judged() const {
    if (!judging_) return std::nullopt;
    return judging_->shot;
}

void Suspicions::add(const ShotReference& drawn, std::vector<ShotReference> prepared, ShotResult ended,
                     bool isForgiven) {
    suspicions_.push_back({drawn, std::move(prepared), std::move(ended), std::nullopt, false, isForgiven});
}

bool Suspicions::concerns(const Suspicion& suspicion, const ShotReference& shot) {
    return suspicion.drawn == shot || std::ranges::find(suspicion.open, shot) != suspicion.open.end();
}

bool Suspicions::isUnder(const ShotReference& shot) const {
    return std::ranges::any_of(suspicions_, [&](const Suspicion& each) { return concerns(each, shot); });
}

std::vector<ShotResult> Suspicions::settle(const ShotReference& shot, const ShotResult& result) {
    const auto found =
        std::ranges::find_if(suspicions_, [&](const Suspicion& each) { return concerns(each, shot); });
    if (found == suspicions_.end()) return {result};
    const bool isGuilty = result.verdict == Verdict::crashed || result.verdict == Verdict::timedOut;
    std::vector<ShotResult> told;
    if (found->drawn == shot && !isGuilty) {
        found->result = result;
    } else {
        told.push_back(result);
        if (std::erase(found->open, shot) > 0 && isGuilty) found->isOtherGuilty = true;
    }
    if (found->result && found->open.empty()) {
        if (found->isForgiven && !found->isOtherGuilty && found->result->verdict == Verdict::passed)
            makeFlaky(*found->result, 2, found->ended);
        told.push_back(found->isOtherGuilty || found->isForgiven ? *found->result : found->ended);
    }
    return told;
}

namespace {

namespace fs = std::filesystem;
using End = base::Outcome::End;

/// The parent process of a run. It gives out pieces, collects their results, and gives out again what a
/// worker had not finished when it ended.
class Run {
  public:
    Run(std::span<const Suite> suites, const RunOptions& options, const RunEvents& events)
        : options_(options),
          events_(events),
          plan_{suites, {}, options, {}, 1},
          sharesDevice_(gpu::mayUseHardware(options.driver)) {
        accepted_.resize(suites.size());
        passed_.resize(suites.size());
        for (const Suite& suite : suites)
            for (const Shot& shot : suite.shots)
                if (!shot.quarantine.empty() || !shot.ignored.empty())
                    dated_.emplace(std::pair(suite.name, shot.name), &shot);
        if (!options.onlyRender.empty()) return;
        for (const Suite& each : suites) {
            Result<GoldenStore> store =
                GoldenStore::open(each, options.goldens, options.allowOutside, options.results / kUploads);
            append(end_.diagnostics, std::move(store.diagnostics));
            plan_.goldens.push_back(std::move(*store));
        }
    }

    RunEnd run(std::span<const ShotReference> shots) {
        std::vector<ShotReference> open(shots.begin(), shots.end());
        count_ = shots.size();
        jobs_ = drawingJobs(options_.jobs, options_.driver, count_);
        plan_.jobs = jobs_;
        while (!open.empty() && !stopped()) {
            // Shots that may be innocent of the end of their worker come last, each alone.
            std::vector<ShotReference> next = open;
            std::erase_if(next, [this](const ShotReference& each) {
                return repeated_.contains(each) || plan_.ended.contains(each);
            });
            if (next.empty()) next.push_back(open.front());
            round(next);
            std::erase_if(open, [this](const ShotReference& each) { return done_.contains(each); });
        }
        end_.stopped = !end_.noDriver && !open.empty();
        for (std::size_t i = 0; i < plan_.goldens.size(); ++i) {
            append(end_.diagnostics, acceptHashes(plan_.goldens[i].hashFile(), accepted_[i]));
            noteLackOfGoldens(i);
        }
        return std::move(end_);
    }

  private:
    /// Where a folder has got another name, nobody would see that nothing is compared any more.
    void noteLackOfGoldens(std::size_t suite) {
        const Suite& of = plan_.suites[suite];
        if (passed_[suite] == 0 || options_.update || plan_.goldens[suite].hasAny(of)) return;
        end_.diagnostics.push_back(diagnose(
            "suite-N01",
            fmt::format("'{}' has no golden of '{}'; {} passed by what the scenes expect, and nothing else",
                        plan_.goldens[suite].folder().generic_string(), of.name,
                        base::counted(passed_[suite], "shot")),
            {of.file.generic_string(), 1, 1}));
    }

    bool stopped() const { return end_.noDriver || (events_.stop && events_.stop()); }

    double timeoutOf(const ShotReference& reference) const {
        return options_.timeout.value_or(plan_.shotOf(reference).timeout);
    }

    std::uint64_t memoryOf(const ShotReference& reference) const {
        if (options_.memory) return *options_.memory;
        return plan_.shotOf(reference).memory.value_or(base::memoryShare(jobs_, count_));
    }

    void round(const std::vector<ShotReference>& open) {
        const auto joins = [&](std::size_t i) {
            return timeoutOf(open[i]) == timeoutOf(open[i - 1]) &&
                   memoryOf(open[i]) == memoryOf(open[i - 1]) && !suspicions_.isUnder(open[i]) &&
                   !suspicions_.isUnder(open[i - 1]);
        };
        plan_.pieces.clear();
        for (const std::vector<std::size_t>& piece : planPieces(open.size(), jobs_, joins)) {
            std::vector<ShotReference>& shots = plan_.pieces.emplace_back();
            for (const std::size_t each : piece) shots.push_back(open[each]);
        }
        begun_.assign(plan_.pieces.size(), {});
        clocks_.assign(plan_.pieces.size(), ShotClocks(limitOf_));
        ShotWorker worker(plan_);
        const base::WorkerOptions options{
            .workers = jobs_,
            .memoryOf = [this](std::size_t piece) { return memoryOf(plan_.pieces[piece].front()); },
            .timeLeft =
                [this](std::size_t piece) {
                    return clocks_[piece]
                        .left(ShotClocks::Clock::now())
                        .value_or(timeoutOf(plan_.pieces[piece].front()));
                },
            .stop = [this] { return stopped(); },
            .sharesDevice = sharesDevice_,
            .repeats = false,  // a piece is done again from where it stopped
            .sandbox = options_.sandbox};
        base::runInWorkers(
            plan_.pieces.size(), options, std::ref(worker),
            [this](std::size_t piece, const base::Outcome& outcome) { pieceEnds(piece, outcome); },
            [this](std::size_t piece, const std::string& text) { hear(piece, text); });
    }

    void hear(std::size_t piece, const std::string& text) {
        std::optional<Message> message = parseMessage(text);
        if (!message) return;
        if (const auto* driver = std::get_if<DriverIs>(&*message)) {
            end_.driver = driver->words;
            driverKey_ = toText(hashOf(std::as_bytes(std::span(driver->key))));
        } else if (const auto* begins = std::get_if<Begins>(&*message)) {
            if (!isOf(piece, begins->shot)) return;
            begun_[piece] = begins->shot;
            clocks_[piece].hear(*begins, ShotClocks::Clock::now());
            if (events_.begins) events_.begins(begins->shot);
        } else if (const auto* phase = std::get_if<Phase>(&*message)) {
            if (isOf(piece, phase->shot)) clocks_[piece].hear(*phase, ShotClocks::Clock::now());
        } else if (auto* done = std::get_if<Done>(&*message)) {
            if (!isOf(piece, done->shot)) return;
            clocks_[piece].hear(*done);
            done->result.suite = plan_.suites[done->shot.suite].name;
            done->result.shot = plan_.shotOf(done->shot).name;
            // Only --update changes the list, whatever a worker says that a scene has taken over.
            if (done->accepted && options_.update) {
                done->accepted->shot = plan_.shotOf(done->shot).name;
                accepted_[done->shot.suite].push_back(std::move(*done->accepted));
            }
            finish(done->shot, done->result);
        }
    }

    /// A worker that a shader has taken over may send anything; it speaks for the shots of its piece only.
    [[nodiscard]] bool isOf(std::size_t piece, const ShotReference& shot) const {
        const std::vector<ShotReference>& shots = plan_.pieces[piece];
        return std::ranges::find(shots, shot) != shots.end();
    }

    /// True if the shot may be drawn again though a drawing of it ended its worker.
    bool forgive(const ShotReference& shot, const ShotResult& result) {
        if (options_.update || !options_.onlyRender.empty()) return false;
        const int times = plan_.ended.contains(shot) ? plan_.ended.at(shot).times : 0;
        if (times >= plan_.shotOf(shot).retries) return false;
        RunPlan::Ended& ended = plan_.ended[shot];
        if (ended.times++ == 0) ended.first = result;
        return true;
    }

    void finish(const ShotReference& shot, ShotResult result) {
        if (!done_.insert(shot).second) return;
        const Shot& drawn = plan_.shotOf(shot);
        passed_[shot.suite] +=
            result.verdict == Verdict::passed && drawn.golden && !drawn.expectedError ? 1 : 0;
        // The first drawing of a shot under suspicion may have been ended by another one.
        const int innocent = suspicions_.isUnder(shot) ? 1 : 0;
        if (const auto ended = plan_.ended.find(shot);
            ended != plan_.ended.end() && ended->second.times > innocent && result.verdict == Verdict::passed)
            makeFlaky(result, ended->second.times + 1, ended->second.first);
        for (ShotResult& each : suspicions_.settle(shot, result)) {
            each.driverKey = driverKey_;
            if (options_.strictFlaky) countFlakyAsFailure(each);
            if (const auto dated = dated_.find({each.suite, each.shot}); dated != dated_.end()) {
                if (!options_.update) quarantine(*dated->second, each);
                reportExpired(*dated->second, each);
            }
            if (events_.done) events_.done(each);
        }
    }

    /// Failures of a shot in quarantine are reported and do not count, up to its last day.
    void quarantine(const Shot& shot, ShotResult& result) const {
        if (shot.quarantine.empty()) return;
        if (today_ > shot.quarantine) {
            result.diagnostics.push_back(
                diagnose("suite-W02",
                         fmt::format("the quarantine of '{}' ended on {}; remove it from the suite",
                                     shot.name, shot.quarantine),
                         shot.place));
        } else if (isFailure(result.verdict)) {
            result.reason = fmt::format("{}, in quarantine until {}: {}", name(result.verdict),
                                        shot.quarantine, result.reason);
            result.verdict = Verdict::quarantined;
        }
    }

    void reportExpired(const Shot& shot, ShotResult& result) const {
        for (const IgnoredRegion& each : shot.ignored)
            if (!each.until.empty() && today_ > each.until)
                result.diagnostics.push_back(diagnose(
                    "suite-W03",
                    fmt::format(
                        "an ignored rectangle of '{}' counts again since {}; remove it from the suite",
                        result.shot, each.until),
                    shot.place));
    }

    void pieceEnds(std::size_t piece, const base::Outcome& outcome) {
        const auto& shots = plan_.pieces[piece];
        if (outcome.end == End::finished) {
            if (end_.noDriver) return;
            if (outcome.answer.empty()) return blameSilent(shots);
            end_.noDriver = true;
            end_.diagnostics.push_back(diagnose("gpu-E01", outcome.answer));
            return;
        }
        removeLeftovers(shots, outcome.process);
        if (outcome.end == End::stopped) return;
        const std::optional<ShotReference> drawn = begun_[piece];
        if (drawn && !done_.contains(*drawn)) {
            const auto known = repeated_.find(*drawn);
            const int times = known == repeated_.end() ? 0 : known->second;
            if (base::mayBeInnocent(outcome, sharesDevice_, times)) {
                ++repeated_[*drawn];
                return;
            }
        }
        // The shot that was being drawn is to blame. Shots that waited for their verdict or their turn are
        // given out again. If no shot was begun, all are given out again, a limited number of times.
        std::optional<ShotReference> blamed = drawn;
        if (outcome.end == End::timedOut && clocks_[piece].latest()) blamed = clocks_[piece].latest();
        if (blamed && done_.contains(*blamed)) blamed.reset();
        if (!blamed) {
            const auto first = std::ranges::find_if(
                shots, [this](const ShotReference& each) { return !done_.contains(each); });
            if (first == shots.end() || ++unexplained_[*first] < kPatience) return;
            blamed = *first;
        }
        ShotResult result = endedBy(*blamed, outcome, clocks_[piece].judged() == blamed);
        // Each shot is late by itself. A crash may come from those that were prepared or judged meanwhile.
        std::vector<ShotReference> prepared;
        if (outcome.end == End::crashed) {
            prepared = preparedBeside(*blamed, shots);
            const std::optional<ShotReference> judged = clocks_[piece].judged();
            if (judged && *judged != *blamed && !done_.contains(*judged) &&
                std::ranges::find(prepared, *judged) == prepared.end())
                prepared.push_back(*judged);
        }
        const bool isForgiven = forgive(*blamed, result);
        if (!prepared.empty())
            suspicions_.add(*blamed, std::move(prepared), std::move(result), isForgiven);
        else if (!isForgiven)
            finish(*blamed, std::move(result));
    }

    /// A worker that ended its piece has reported a verdict on each shot. If one is missing or was no
    /// verdict, the shot is given out again, but not for ever.
    void blameSilent(const std::vector<ShotReference>& shots) {
        for (const ShotReference& each : shots)
            if (!done_.contains(each) && ++unexplained_[each] >= kPatience)
                finish(each, endedBy(each, {.end = End::crashed}));
    }

    [[nodiscard]] std::vector<ShotReference> preparedBeside(const ShotReference& drawn,
                                                            const std::vector<ShotReference>& shots) const {
        std::vector<ShotReference> prepared;
        auto next = std::ranges::find(shots, drawn);
        for (std::size_t i = 0; i < kShotsAhead && next != shots.end() && ++next != shots.end(); ++i)
            if (!done_.contains(*next)) prepared.push_back(*next);
        return prepared;
    }

    [[nodiscard]] ShotResult endedBy(const ShotReference& blamed, const base::Outcome& outcome,
                                     bool isJudged = false) const {
        const bool late = outcome.end == End::timedOut;
        std::string reason = late ? fmt::format("not {} within {:g} seconds", isJudged ? "compared" : "drawn",
                                                timeoutOf(blamed))
                             : outcome.signal > 0
                                 ? fmt::format("the process that drew it ended with signal {} ({})",
                                               outcome.signal, system::signalReason(outcome.signal))
                                 : "the process that drew it ended by itself";
        if (outcome.nearMemoryLimit) reason += ", perhaps because it reached its limit of memory (--memory)";
        const std::string script = plan_.shotOf(blamed).script.generic_string();
        Diagnostic problem = diagnose(late ? "draw-E07" : "draw-E06", reason, {script, 1, 1});
        if (outcome.end == End::deviceLost) problem = base::diagnosticOf(outcome.lost, script);
        ShotResult result = ShotJudge::broken(plan_.suites[blamed.suite], plan_.shotOf(blamed),
                                              late ? Verdict::timedOut : Verdict::crashed, problem.text);
        result.accept.clear();
        result.diagnostics.push_back(std::move(problem));
        return result;
    }

    /// Removes the files that a worker was writing when it ended.
    void removeLeftovers(const std::vector<ShotReference>& shots, int process) const {
        std::set<fs::path> folders;
        for (const ShotReference& each : shots) {
            const Suite& suite = plan_.suites[each.suite];
            const Shot& shot = plan_.shotOf(each);
            if (!options_.onlyRender.empty()) {
                folders.insert(
                    pictureFile(options_.onlyRender, suite, shot, plan_.suites.size() > 1).parent_path());
                continue;
            }
            folders.insert((options_.results / suite.name / shot.name).parent_path());
            if (options_.update) folders.insert(plan_.goldens[each.suite].file(shot, "").parent_path());
        }
        for (const fs::path& each : folders) image::removeTemporaryFiles(each, process);
    }

    static constexpr int kPatience = 3;  ///< pieces that may end without a word on a shot

    const RunOptions& options_;
    const RunEvents& events_;
    RunPlan plan_;
    RunEnd end_;
    std::map<ShotKey, const Shot*> dated_;  ///< shots with a quarantine or ignored rectangles
    const std::string today_ = today();
    int jobs_ = 1;
    std::size_t count_ = 0;  ///< of the shots
    std::set<ShotReference> done_;
    Suspicions suspicions_;
    const bool sharesDevice_;
    std::map<ShotReference, int> repeated_;     ///< how often each was drawn again, alone
    std::map<ShotReference, int> unexplained_;  ///< number of workers that ended before they began a shot
    std::vector<std::optional<ShotReference>> begun_;  ///< last shot begun, per piece
    const std::function<double(const ShotReference&)> limitOf_ = [this](const ShotReference& shot) {
        return timeoutOf(shot);
    };
    std::vector<ShotClocks> clocks_;                   ///< per piece
    std::string driverKey_;                            ///< ShotResult::driverKey
    std::vector<std::vector<AcceptedHash>> accepted_;  ///< per suite
    std::vector<std::size_t> passed_;                  ///< per suite, of the shots that want a golden
};

}  // namespace

RunEnd runShots(std::span<const Suite> suites, std::span<const ShotReference> shots,
                const RunOptions& options, const RunEvents& events) {
    return Run(suites, options, events).run(shots);
}

}  // namespace glibra::suite
