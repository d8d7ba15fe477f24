#include "suite/run_worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>

#include "image/write.h"
#include "render/job.h"
#include "suite/hash_key.h"
#include "suite/unknown_uniforms.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Does jobs in order on a thread of its own. At most two wait, so that pictures in memory stay few.
class Background {
  public:
    Background() : thread_([this] { run(); }) {}
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;
    ~Background() { finish(); }

    void add(std::function<void()> job) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return waiting_.size() < 2; });
        waiting_.push_back(std::move(job));
        changed_.notify_all();
    }
    void finish() {
        {
            const std::scoped_lock lock(mutex_);
            closed_ = true;
            changed_.notify_all();
        }
        if (thread_.joinable()) thread_.join();
    }

  private:
    void run() {
        while (true) {
            std::function<void()> job;
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [this] { return !waiting_.empty() || closed_; });
                if (waiting_.empty()) return;
                job = std::move(waiting_.front());
                waiting_.pop_front();
                changed_.notify_all();
            }
            job();
        }
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::function<void()>> waiting_;
    bool closed_ = false;
    std::thread thread_;
};

/// Hands shots that have to be rendered once more from the judging thread to the one with the context.
class Recalls {
  public:
    struct Recall {
        ShotReference reference;
        std::shared_ptr<const Attempt> attempt;
    };
    void add(Recall recall) {
        const std::scoped_lock lock(mutex_);
        recalls_.push_back(std::move(recall));
    }
    std::optional<Recall> next() {
        const std::scoped_lock lock(mutex_);
        if (recalls_.empty()) return std::nullopt;
        Recall first = std::move(recalls_.front());
        recalls_.pop_front();
        return first;
    }

  private:
    std::mutex mutex_;
    std::deque<Recall> recalls_;
};

}  // namespace

const Shot& ShotWorker::shotOf(const ShotReference& reference) const {
    return plan_.suites[reference.suite].shots[reference.shot];
}

std::string ShotWorker::openContext() {
    if (context_) return {};
    shareProcessors(plan_.jobs, plan_.pieces.size());
    Result<gpu::Context> opened = gpu::openContext({.driver = plan_.options.driver});
    if (!opened) return opened.diagnostics.empty() ? "no driver" : opened.diagnostics.front().text;
    context_.emplace(std::move(*opened));
    const gpu::Capabilities& driver = context_->capabilities();
    driver_ = driver.renderer + ", " + driver.version;
    const JudgeOptions options{plan_.options.update, plan_.options.force, plan_.options.variant,
                               plan_.options.results};
    for (std::size_t i = 0; i < plan_.goldens.size(); ++i)
        judges_.emplace_back(plan_.suites[i], plan_.goldens[i], driver.family, driverKey(driver), options);
    return {};
}

Rendering ShotWorker::render(const Shot& shot) {
    Rendering rendering;
    RenderOptions options = shot.options;
    options.time = 0;
    options.skip = plan_.options.skip;
    if (!loaded_ || loaded_->script != shot.script || loaded_->options != options ||
        loaded_->renderer.remembersFrames()) {
        loaded_.reset();
        auto stats = std::make_unique<render::Stats>();
        Result<render::SceneRenderer> renderer =
            render::SceneRenderer::load(*context_, shot.script, options, *stats, &shared_);
        if (!renderer) {
            rendering.diagnostics = std::move(renderer.diagnostics);
            return rendering;
        }
        loaded_.emplace(Loaded{shot.script,
                               options,
                               std::move(stats),
                               std::move(*renderer),
                               std::move(renderer.diagnostics),
                               std::nullopt,
                               {}});
    }
    rendering.diagnostics = loaded_->diagnostics;
    Result<image::Image> picture = draw(shot.options.time);
    append(rendering.diagnostics, std::move(picture.diagnostics));
    rendering.picture = std::move(picture.value);
    if (rendering.picture) {
        append(rendering.diagnostics,
               render::remarksOn(*rendering.picture, shot.script, loaded_->renderer.plan()));
        render::applyStrict(rendering.diagnostics, shot.options.strict);
    }
    return rendering;
}

/// Draws with the scene that is loaded, or gives its last picture once more.
Result<image::Image> ShotWorker::draw(double time) {
    const std::optional<render::Moment> moment =
        plan_.options.skip ? loaded_->renderer.momentOf(time) : std::nullopt;
    if (moment && loaded_->picture && loaded_->moment == *moment) return *loaded_->picture;
    Result<image::Image> picture = loaded_->renderer.draw(time, *loaded_->stats);
    loaded_->picture.reset();
    // A picture with remarks is drawn again: the next shot is to hear them too.
    if (moment && picture && picture.diagnostics.empty()) {
        loaded_->picture = *picture;
        loaded_->moment = *moment;
    }
    return picture;
}

void ShotWorker::forget() {
    loaded_.reset();
    shared_ = {};
}

Rendering ShotWorker::tryRender(const Shot& shot) {
    const Clock::time_point start = Clock::now();
    Rendering rendering;
    const auto fail = [&](const char* id, const char* text) {
        forget();
        rendering = {};
        rendering.diagnostics.push_back(error(id, text, {shot.script.string(), 1, 1}));
    };
    try {
        rendering = render(shot);
        if (!shot.expectedError) reportUnknownUniforms(shot, rendering.diagnostics);
        if (hasError(rendering.diagnostics)) rendering.picture.reset();
    } catch (const std::bad_alloc&) {
        fail("draw-E05", "out of memory");
    } catch (const std::exception& failure) {
        fail("draw-E06", failure.what());
    }
    rendering.milliseconds = millisecondsSince(start);
    return rendering;
}

Attempt ShotWorker::attempt(const ShotReference& reference) {
    const Suite& suite = plan_.suites[reference.suite];
    const Shot& shot = shotOf(reference);
    Attempt attempt;
    attempt.shot = &shot;
    const auto partner = [&](const std::string& name) -> std::optional<Rendering> {
        if (name.empty() || !plan_.options.onlyRender.empty()) return std::nullopt;
        const auto found = std::find_if(suite.shots.begin(), suite.shots.end(),
                                        [&](const Shot& each) { return each.name == name; });
        if (found == suite.shots.end()) return std::nullopt;
        return tryRender(*found);
    };
    attempt.own = tryRender(shot);
    if (attempt.own.picture) {
        attempt.match = partner(shot.match);
        attempt.differ = partner(shot.differ);
    }
    return attempt;
}

Judged ShotWorker::keep(const ShotReference& reference, const Attempt& attempt) const {
    const Shot& shot = *attempt.shot;
    const Suite& suite = plan_.suites[reference.suite];
    Judged judged{ShotJudge::broken(suite, shot, Verdict::passed, {}), std::nullopt};
    ShotResult& result = judged.result;
    result.accept.clear();
    result.diagnostics = attempt.own.diagnostics;
    if (attempt.own.picture) {
        result.width = attempt.own.picture->width;
        result.height = attempt.own.picture->height;
        result.got = pictureFile(plan_.options.onlyRender, suite, shot, plan_.suites.size() > 1);
        std::error_code ignored;  // reported with the file that cannot be written
        fs::create_directories(result.got.parent_path(), ignored);
        append(result.diagnostics, image::writeImage(*attempt.own.picture, result.got));
    }
    const bool expected = shot.expectedError && contains(result.diagnostics, *shot.expectedError);
    if (hasError(result.diagnostics) && !expected) {
        result.verdict = Verdict::failed;
        for (const Diagnostic& each : result.diagnostics)
            if (each.severity == Severity::error && result.reason.empty()) result.reason = toString(each);
    }
    return judged;
}

std::string ShotWorker::operator()(std::size_t piece, const render::Step& step) {
    std::mutex talking;
    const auto tell = [&](const Message& message) {
        const std::scoped_lock lock(talking);
        step(toText(message));
    };
    const auto report = [&](const ShotReference& reference, Judged judged, Clock::time_point judging) {
        judged.result.milliseconds += millisecondsSince(judging);
        tell(Done{reference, std::move(judged.result), std::move(judged.accepted)});
    };
    Recalls recalls;
    const auto renderRecalled = [&] {
        while (const std::optional<Recalls::Recall> recall = recalls.next()) {
            tell(Begins{recall->reference});
            forget();
            const Attempt again = attempt(recall->reference);
            const Clock::time_point start = Clock::now();
            report(recall->reference, judges_[recall->reference.suite].second(*recall->attempt, again),
                   start);
        }
    };

    Background judging;
    for (const ShotReference& reference : plan_.pieces[piece]) {
        tell(Begins{reference});
        const bool first = !context_;
        if (std::string problem = openContext(); !problem.empty()) return problem;
        if (first) tell(DriverIs{driver_});
        auto drawn = std::make_shared<const Attempt>(attempt(reference));
        judging.add([this, reference, drawn, &report, &recalls] {
            const Clock::time_point start = Clock::now();
            if (judges_.empty())
                report(reference, keep(reference, *drawn), start);
            else if (std::optional<Judged> judged = judges_[reference.suite].first(*drawn))
                report(reference, std::move(*judged), start);
            else
                recalls.add({reference, drawn});
        });
        drawn.reset();
        renderRecalled();
    }
    judging.finish();
    renderRecalled();
    return {};
}

}  // namespace glibra::suite
