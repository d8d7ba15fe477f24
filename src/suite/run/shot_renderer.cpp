#include "suite/run/shot_renderer.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <new>
#include <string_view>

#include "base/contained.h"
#include "base/device_lost.h"
#include "base/text.h"
#include "image/write.h"
#include "render/check/run_checks.h"
#include "render/consequences.h"
#include "render/file/job.h"
#include "suite/golden/hash_list.h"
#include "suite/options/option_table.h"

namespace glibra::suite {

ShotRenderer::Source ShotRenderer::sourceOf(const Shot& shot) const {
    Shot stated = shot;
    giveToAll(ofAll_, stated);
    Source source{shot.script, std::move(stated.options)};
    source.options.time = 0;
    source.options.checks = true;
    return source;
}

void ShotRenderer::prepare(std::span<const Shot* const> coming, const Source& current) {
    const Source* before = &current;
    std::size_t wanted = 0;
    for (const Shot* each : coming) {
        Source source = sourceOf(*each);
        if (source == *before) continue;
        if (wanted == preparations_.size() || !(preparations_[wanted].source == source)) {
            dropPreparationsFrom(wanted);
            beginPreparation(*each, std::move(source));
        }
        before = &preparations_[wanted++].source;
    }
}

void ShotRenderer::beginPreparation(const Shot& shot, Source source) {
    Preparation& begun = preparations_.emplace_back();
    begun.shot = &shot;
    begun.source = std::move(source);
    begun.stats = std::make_unique<render::Stats>();
    begun.job = background_.add([this, &begun] {
        try {
            begun.scene = render::SceneRenderer::prepare(context_, begun.source.script, begun.source.options,
                                                         *begun.stats, &*shared_);
        } catch (const std::exception&) {
            // Several scenes at once may need too much memory. load() tries this one alone.
            begun.scene.reset();
        }
    });
}

void ShotRenderer::dropPreparationsFrom(std::size_t first) {
    if (first >= preparations_.size()) return;
    for (const Preparation& each : preparations_) {
        if (awaits_) awaits_(each.shot);
        background_.wait(each.job);
    }
    if (awaits_) awaits_(nullptr);
    while (preparations_.size() > first) preparations_.pop_back();
}

/// Sets loaded_ to the scene, or resets it and returns the errors.
Diagnostics ShotRenderer::load(const Source& source, std::span<const Shot* const> coming) {
    loaded_.reset();
    auto stats = std::make_unique<render::Stats>();
    std::optional<render::PreparedScene> prepared;
    if (!preparations_.empty() && preparations_.front().source == source) {
        Preparation& own = preparations_.front();
        background_.wait(own.job);
        if (own.scene) {
            prepared = std::move(own.scene);
            stats = std::move(own.stats);
            preparations_.pop_front();
        } else {
            dropPreparationsFrom(0);
            coming = {};
        }
    }
    prepare(coming, source);
    Result<render::SceneRenderer> renderer =
        prepared ? render::SceneRenderer::load(std::move(*prepared), *stats)
                 : render::SceneRenderer::load(context_, source.script, source.options, *stats, &*shared_);
    if (!renderer) return std::move(renderer.diagnostics);
    loaded_.emplace(Loaded{
        source, std::move(stats), std::move(*renderer), std::move(renderer.diagnostics), std::nullopt, {}});
    return {};
}

Rendering ShotRenderer::tryRender(const Shot& shot, std::span<const Shot* const> coming) {
    Rendering rendering;
    const Source source = sourceOf(shot);
    if (loaded_ && loaded_->source == source && !loaded_->renderer.remembersFrames())
        prepare(coming, source);
    else if (Diagnostics problems = load(source, coming); !loaded_) {
        RenderOptions options = source.options;
        options.time = shot.options.time;
        rendering.diagnostics = render::answerWithoutPicture(source.script, options, std::move(problems));
        rendering.failsAsExpected = !hasError(rendering.diagnostics);
        return rendering;
    }
    rendering.diagnostics = loaded_->diagnostics;
    Result<image::Image> picture = draw(shot.options.time);
    append(rendering.diagnostics, std::move(picture.diagnostics));
    rendering.picture = std::move(picture.value);
    if (rendering.picture) {
        append(rendering.diagnostics,
               render::remarksOn(*rendering.picture, shot.script, loaded_->renderer.plan()));
        render::applyStrict(rendering.diagnostics, shot.options.strict);
        rendering.hasChecks = render::hasChecks(loaded_->renderer.scene());
        if (rendering.hasChecks || !loaded_->renderer.scene().idleChecks.empty())
            rendering.failedChecks = render::answerChecks(loaded_->renderer, shot.options.time,
                                                          rendering.diagnostics, *loaded_->stats);
    }
    return rendering;
}

/// Draws the loaded scene, or returns its last picture again.
Result<image::Image> ShotRenderer::draw(double time) {
    const std::optional<render::Moment> moment =
        loaded_->source.options.skip ? loaded_->renderer.momentOf(time) : std::nullopt;
    if (moment && loaded_->picture && loaded_->moment == *moment) return *loaded_->picture;
    Result<image::Image> picture = loaded_->renderer.draw(time, *loaded_->stats);
    loaded_->picture.reset();
    // A picture with diagnostics is not kept, so that every shot reports them.
    if (moment && picture && picture.diagnostics.empty()) {
        loaded_->picture = *picture;
        loaded_->moment = *moment;
    }
    return picture;
}

void ShotRenderer::forget() {
    dropPreparationsFrom(0);
    loaded_.reset();
    shared_.emplace();
}

Rendering ShotRenderer::render(const Shot& shot, std::span<const Shot* const> coming) {
    const auto start = std::chrono::steady_clock::now();
    Rendering rendering;
    const auto fail = [&](const char* id, const std::exception& failure) {
        forget();
        rendering = {};
        rendering.diagnostics.push_back(
            diagnose(id, base::reasonOf(failure), {shot.script.generic_string(), 1, 1}));
    };
    try {
        rendering = tryRender(shot, coming);
        if (!shot.expectedError) reportUnknownUniforms(shot, rendering.diagnostics);
        if (rendering.picture)
            append(rendering.failedChecks, render::takeMisspellings(rendering.diagnostics));
        if (hasError(rendering.diagnostics) && !shot.options.incomplete) rendering.picture.reset();
    } catch (const base::DeviceLost&) {
        throw;  // the worker must not be used any more
    } catch (const std::bad_alloc& failure) {
        fail("draw-E05", failure);
    } catch (const std::exception& failure) {
        fail("draw-E06", failure);
    }
    rendering.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return rendering;
}

namespace {

/// "uKd" of "Dots:uKd".
std::string_view withoutProgram(std::string_view name) {
    const std::size_t colon = name.rfind(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

}  // namespace

void reportUnknownUniforms(const Shot& shot, Diagnostics& diagnostics) {
    for (Diagnostic& each : diagnostics) {
        // A pair in the scene has its own place there.
        if (each.id != "glib-W23" || !each.place.file.empty()) continue;
        const auto isAbout = [&](const PlacedUniform& uniform) {
            return each.subject == withoutProgram(uniform.name);
        };
        const auto found = std::ranges::find_if(shot.ownUniforms, isAbout);
        if (found != shot.ownUniforms.end()) each = diagnose("suite-E19", each.text, found->place);
    }
}

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Passes shots that must be rendered again from the judging thread to the thread with the context.
class Recalls {
  public:
    struct Recall {
        ShotReference reference;
        std::shared_ptr<const Attempt> attempt;
        int drawing = 2;               ///< the number of the drawing that is asked for
        std::optional<Judged> failed;  ///< the verdict so far, if there is one
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

std::size_t bytesOf(const Attempt& attempt) {
    std::size_t bytes = 0;
    for (const Rendering* each : {&attempt.own, attempt.match ? &*attempt.match : nullptr,
                                  attempt.differ ? &*attempt.differ : nullptr})
        if (each && each->picture) bytes += each->picture->data.size();
    return bytes;
}

}  // namespace

std::string ShotWorker::openContext() {
    if (context_) return {};
    shareProcessors(plan_.jobs, plan_.pieces.size());
    Result<gpu::Context> opened = gpu::openContext({.driver = plan_.options.driver});
    if (!opened) return opened.diagnostics.empty() ? "no driver" : opened.diagnostics.front().text;
    context_.emplace(std::move(*opened));
    renderer_.emplace(*context_, plan_.options.ofAll, [this](const Shot* shot) { awaits_(shot); });
    const gpu::Capabilities& driver = context_->capabilities();
    driver_ = driver.renderer + ", " + driver.version;
    driverKey_ = driverKey(driver);
    JudgeOptions options(plan_.options);
    for (std::size_t i = 0; i < plan_.goldens.size(); ++i) {
        if (i < plan_.options.orphansBySuite.size()) options.orphans = plan_.options.orphansBySuite[i];
        judges_.emplace_back(plan_.suites[i], plan_.goldens[i], driver.family, driverKey_, options);
    }
    return {};
}

Attempt ShotWorker::attempt(const ShotReference& reference, std::span<const Shot* const> coming) {
    const Shot& shot = plan_.shotOf(reference);
    Attempt attempt;
    attempt.shot = &shot;
    const auto partner = [&](const std::string& name) -> std::optional<Rendering> {
        if (name.empty() || !plan_.options.onlyRender.empty()) return std::nullopt;
        const Shot* found = plan_.suites[reference.suite].find(name);
        return found ? std::optional(renderer_->render(*found)) : std::nullopt;
    };
    attempt.own = renderer_->render(shot, coming);
    // A golden must not show one order of threads out of many.
    if (plan_.options.update && attempt.own.picture)
        append(attempt.own.diagnostics, render::checkOrder(*context_, shot.script, shot.options));
    // What lacks something is shown, but never judged.
    if (plan_.options.onlyRender.empty() && hasError(attempt.own.diagnostics)) attempt.own.picture.reset();
    if (attempt.own.picture) {
        attempt.match = partner(shot.match);
        attempt.differ = partner(shot.differ);
    }
    return attempt;
}

Judged ShotWorker::keep(const ShotReference& reference, const Attempt& attempt) const {
    const Shot& shot = *attempt.shot;
    const Suite& suite = plan_.suites[reference.suite];
    Judged judged{ShotJudge::broken(suite, shot, Verdict::passed, {})};
    ShotResult& result = judged.result;
    result.accept.clear();
    result.diagnostics = attempt.own.diagnostics;
    for (const Diagnostic& each : attempt.own.failedChecks) {
        if (each.id.starts_with("check-")) continue;
        result.diagnostics.push_back(each);
        if (!plan_.options.refusesMisspelt) result.diagnostics.back().severity = severityOf(each.id);
    }
    if (attempt.own.picture) {
        result.width = attempt.own.picture->width;
        result.height = attempt.own.picture->height;
        result.got = pictureFile(plan_.options.onlyRender, suite, shot, plan_.suites.size() > 1);
        // No link below the folder that the user named is followed. A failure is reported with the file.
        if (base::makeFoldersBeneath(plan_.options.onlyRender, result.got.parent_path().lexically_relative(
                                                                   plan_.options.onlyRender)) == ELOOP)
            result.diagnostics.push_back(image::cannotWrite(result.got, "its folder is a link"));
        else
            append(result.diagnostics, image::writeImage(*attempt.own.picture, result.got,
                                                         image::writtenAs(image::NamedBy::program)));
    }
    const bool expected = shot.expectedError && contains(result.diagnostics, *shot.expectedError);
    if (hasError(result.diagnostics) && !expected) {
        result.verdict = Verdict::failed;
        for (const Diagnostic& each : result.diagnostics)
            if (each.severity == Severity::error && result.reason.empty()) result.reason = toString(each);
    }
    return judged;
}

std::optional<Judged> ShotWorker::judge(const ShotReference& reference, const Attempt& drawn,
                                        const Attempt* again) const {
    const auto fail = [&](const char* id, const std::string& text) {
        Judged judged{ShotJudge::broken(plan_.suites[reference.suite], *drawn.shot, Verdict::failed, text),
                      std::nullopt};
        judged.result.diagnostics.push_back(diagnose(id, text, {drawn.shot->script.generic_string(), 1, 1}));
        return judged;
    };
    try {
        if (judges_.empty()) return keep(reference, drawn);
        const ShotJudge& judge = judges_[reference.suite];
        return again ? judge.second(drawn, *again) : judge.first(drawn);
    } catch (const std::bad_alloc& failure) {
        return fail("draw-E05", "the picture is not compared: " + base::reasonOf(failure));
    } catch (const std::exception& failure) {
        return fail("draw-E06", base::reasonOf(failure));
    }
}

int ShotWorker::retriesLeft(const ShotReference& reference) const {
    if (plan_.options.update || !plan_.options.onlyRender.empty()) return 0;
    const auto ended = plan_.ended.find(reference);
    return plan_.shotOf(reference).retries - (ended == plan_.ended.end() ? 0 : ended->second.times);
}

std::string ShotWorker::operator()(std::size_t piece, const base::Step& step) {
    std::mutex sending;
    const auto send = [&](const Message& message) {
        const std::scoped_lock lock(sending);
        step(toText(message));
    };
    Recalls recalls;
    /// Sends the verdict, or asks for another rendering. `soFar.failed` is the verdict on the drawings
    /// before.
    const auto report = [&](Recalls::Recall soFar, const Attempt* again) {
        const Clock::time_point start = Clock::now();
        const ShotReference reference = soFar.reference;
        const std::shared_ptr<const Attempt> drawn = soFar.attempt;
        const int drawing = soFar.drawing;
        const auto askAgain = [&](std::optional<Judged> failed) {
            send(Phase{Phase::Kind::recalls, reference});
            recalls.add({reference, drawn, drawing + 1, std::move(failed)});
        };
        std::optional<Judged> judged =
            soFar.failed ? std::move(soFar.failed) : judge(reference, *drawn, again);
        if (!judged) return askAgain(std::nullopt);
        if (const int retries = retriesLeft(reference); retries > 0 && isFailure(judged->result.verdict)) {
            const std::optional<Judged> other = again ? judge(reference, *again, nullptr) : std::nullopt;
            if (other && other->result.verdict == Verdict::passed)
                makeFlaky(judged->result, drawing, judged->result);
            else if (drawing <= retries)
                return askAgain(std::move(judged));
        }
        judged->result.milliseconds +=
            std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        send(Done{reference, std::move(judged->result), std::move(judged->accepted)});
    };
    const std::vector<ShotReference>& shots = plan_.pieces[piece];
    ShotReference current;
    awaits_ = [&](const Shot* shot) {
        const auto found = std::ranges::find_if(
            shots, [&](const ShotReference& each) { return &plan_.shotOf(each) == shot; });
        send(Phase{Phase::Kind::awaits, found == shots.end() ? current : *found});
    };
    const auto renderRecalled = [&] {
        while (const std::optional<Recalls::Recall> recall = recalls.next()) {
            current = recall->reference;
            send(Begins{recall->reference});
            renderer_->forget();
            const Attempt again = attempt(recall->reference, {});
            report(*recall, &again);
        }
    };

    Background judging;
    for (std::size_t i = 0; i < shots.size(); ++i) {
        const ShotReference reference = current = shots[i];
        send(Begins{reference});
        const bool first = !context_;
        if (std::string problem = openContext(); !problem.empty()) return problem;
        if (first) send(DriverIs{driver_, driverKey_});
        std::vector<const Shot*> coming;
        for (std::size_t next = i + 1; next < shots.size() && coming.size() < kShotsAhead; ++next)
            coming.push_back(&plan_.shotOf(shots[next]));
        auto drawn = std::make_shared<const Attempt>(attempt(reference, coming));
        const std::size_t bytes = bytesOf(*drawn);
        send(Phase{Phase::Kind::drawn, reference});
        judging.add(
            [reference, drawn, &report, &send] {
                send(Phase{Phase::Kind::judges, reference});
                report({reference, drawn, 1, std::nullopt}, nullptr);
            },
            bytes);
        drawn.reset();
        renderRecalled();
    }
    judging.finish();
    renderRecalled();
    return {};
}

}  // namespace glibra::suite
