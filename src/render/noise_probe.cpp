#include "render/noise_probe.h"

#include <variant>
#include <vector>

#include "render/probe_options.h"
#include "render/scene_renderer.h"

namespace glibra::render {
namespace {

constexpr int kLargestSide = 200;

scene::Scene with(scene::Scene scene, std::span<const budget::NoiseChoice> noise) {
    budget::Choice choice;
    choice.noise.assign(noise.begin(), noise.end());
    budget::apply(choice, scene);
    return scene;
}

}  // namespace

std::optional<budget::ContourShifts> noiseShift(gpu::Context& context, const scene::Scene& scene,
                                                const RenderOptions& options, int width, int height,
                                                std::span<const budget::NoiseChoice> from,
                                                std::span<const budget::NoiseChoice> to) {
    ProbeOptions probe = probeOptions(options, width, height, kLargestSide);
    probe.options.floatPixels = true;
    probe.options.alpha = false;
    Stats stats;
    SharedParts parts;  // both pictures have all but the noise in common
    const auto picture = [&](std::span<const budget::NoiseChoice> noise) -> Result<image::Image> {
        Result<SceneRenderer> renderer =
            SceneRenderer::of(context, with(scene, noise), probe.options, stats, &parts);
        if (!renderer) return std::move(renderer.diagnostics);
        return renderer->draw(options.time, stats);
    };
    const Result<image::Image> before = picture(from), after = picture(to);
    if (!before || !after) return std::nullopt;
    return budget::ContourShifts(*before, *after, probe.shrink);
}

}  // namespace glibra::render
