#include "suite/shot_renderer.h"

#include <chrono>
#include <new>
#include <utility>

#include "render/job.h"
#include "suite/unknown_uniforms.h"

namespace glibra::suite {

ShotRenderer::Source ShotRenderer::sourceOf(const Shot& shot) const {
    Source source{shot.script, shot.options};
    source.options.time = 0;
    source.options.skip = skip_;
    return source;
}

void ShotRenderer::prepare(const Shot* next, const Source& current) {
    if (!next) return;
    Source source = sourceOf(*next);
    if (preparation_ && preparation_->source == source) return;
    background_.wait();
    preparation_.reset();  // nobody came for it
    if (source == current) return;
    Preparation& begun = preparation_.emplace();
    begun.source = std::move(source);
    begun.stats = std::make_unique<render::Stats>();
    background_.add([this, &begun] {
        try {
            begun.scene = render::SceneRenderer::prepare(context_, begun.source.script, begun.source.options,
                                                         *begun.stats, &*shared_);
        } catch (const std::exception&) {
            // Two scenes at once may have been too much for the memory: load() tries it by itself.
            begun.scene.reset();
        }
    });
}

/// Leaves loaded_ with the scene, or empty for the reasons given.
Diagnostics ShotRenderer::load(const Source& source, const Shot* next) {
    loaded_.reset();
    auto stats = std::make_unique<render::Stats>();
    std::optional<render::PreparedScene> prepared;
    if (preparation_ && preparation_->source == source) {
        background_.wait();
        if (preparation_->scene) {
            prepared = std::move(preparation_->scene);
            stats = std::move(preparation_->stats);
        } else {
            next = nullptr;
        }
        preparation_.reset();
    }
    prepare(next, source);
    Result<render::SceneRenderer> renderer =
        prepared ? render::SceneRenderer::load(std::move(*prepared), *stats)
                 : render::SceneRenderer::load(context_, source.script, source.options, *stats, &*shared_);
    if (!renderer) return std::move(renderer.diagnostics);
    loaded_.emplace(Loaded{
        source, std::move(stats), std::move(*renderer), std::move(renderer.diagnostics), std::nullopt, {}});
    return {};
}

Rendering ShotRenderer::tryRender(const Shot& shot, const Shot* next) {
    Rendering rendering;
    const Source source = sourceOf(shot);
    if (loaded_ && loaded_->source == source && !loaded_->renderer.remembersFrames())
        prepare(next, source);
    else if (Diagnostics problems = load(source, next); !loaded_) {
        rendering.diagnostics = std::move(problems);
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
    }
    return rendering;
}

/// Draws with the scene that is loaded, or gives its last picture once more.
Result<image::Image> ShotRenderer::draw(double time) {
    const std::optional<render::Moment> moment = skip_ ? loaded_->renderer.momentOf(time) : std::nullopt;
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

void ShotRenderer::forget() {
    background_.wait();
    preparation_.reset();
    loaded_.reset();
    shared_.emplace();
}

Rendering ShotRenderer::render(const Shot& shot, const Shot* next) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    Rendering rendering;
    const auto fail = [&](const char* id, const char* text) {
        forget();
        rendering = {};
        rendering.diagnostics.push_back(error(id, text, {shot.script.string(), 1, 1}));
    };
    try {
        rendering = tryRender(shot, next);
        if (!shot.expectedError) reportUnknownUniforms(shot, rendering.diagnostics);
        if (hasError(rendering.diagnostics)) rendering.picture.reset();
    } catch (const std::bad_alloc&) {
        fail("draw-E05", "out of memory");
    } catch (const std::exception& failure) {
        fail("draw-E06", failure.what());
    }
    rendering.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    return rendering;
}

}  // namespace glibra::suite
