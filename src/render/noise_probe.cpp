#include "render/noise_probe.h"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

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
    const double shrink = std::max(1., static_cast<double>(std::max(width, height)) / kLargestSide);
    RenderOptions small = options;
    small.width = std::max(1, static_cast<int>(std::lround(width / shrink)));
    small.height = std::max(1, static_cast<int>(std::lround(height / shrink)));
    small.maxError = 0;
    small.samples = 1;
    small.floatPixels = true;
    small.tileSize = 0;
    small.axes = small.alpha = small.checkNan = small.strict = false;
    Stats stats;
    SharedParts parts;  // both pictures have all but the noise in common
    const auto picture = [&](std::span<const budget::NoiseChoice> noise) -> Result<image::Image> {
        Result<SceneRenderer> renderer = SceneRenderer::of(context, with(scene, noise), small, stats, &parts);
        if (!renderer) return std::move(renderer.diagnostics);
        return renderer->draw(options.time, stats);
    };
    const Result<image::Image> before = picture(from), after = picture(to);
    if (!before || !after) return std::nullopt;
    return budget::ContourShifts(*before, *after, shrink);
}

}  // namespace glibra::render
