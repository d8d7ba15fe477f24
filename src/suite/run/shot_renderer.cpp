#include "suite/run/shot_renderer.h"

#include <chrono>
#include <new>
#include <utility>

#include "base/device_lost.h"
#include "render/check/run_checks.h"
#include "render/consequences.h"
#include "render/file/job.h"
#include "suite/file/unknown_uniforms.h"
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
    const auto fail = [&](const char* id, const char* text) {
        forget();
        rendering = {};
        rendering.diagnostics.push_back(diagnose(id, text, {shot.script.generic_string(), 1, 1}));
    };
    try {
        rendering = tryRender(shot, coming);
        if (!shot.expectedError) reportUnknownUniforms(shot, rendering.diagnostics);
        if (rendering.picture)
            append(rendering.failedChecks, render::takeMisspellings(rendering.diagnostics));
        if (hasError(rendering.diagnostics) && !shot.options.incomplete) rendering.picture.reset();
    } catch (const base::DeviceLost&) {
        throw;  // the worker must not be used any more
    } catch (const std::bad_alloc&) {
        fail("draw-E05", "out of memory");
    } catch (const std::exception& failure) {
        fail("draw-E06", failure.what());
    }
    rendering.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return rendering;
}

}  // namespace glibra::suite
