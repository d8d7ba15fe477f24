#include "render/probe/picture_probe.h"

#include <algorithm>
#include <utility>

#include "render/probe/probe_options.h"
#include "render/scene_state.h"

namespace glibra::render {
namespace {

constexpr int kNoiseSide = 200, kLeastSide = 320, kMostSide = 800;

/// For meshes, shifts of a tenth of a pixel can be measured, so a picture in which the bound is that much is
/// large enough.
int largestSide(const budget::Choice& choice, const RenderOptions& options, int side) {
    if (!choice.noise.empty()) return kNoiseSide;
    return static_cast<int>(std::clamp(.1 * side / options.maxError, double{kLeastSide}, double{kMostSide}));
}

}  // namespace

std::optional<budget::ContourShifts> PictureProbe::shift(const budget::Choice& from,
                                                         const budget::Choice& to) const {
    ProbeOptions probe =
        probeOptions(options, width, height, largestSide(from, options, std::max(width, height)));
    // Noise changes values by less than a byte can show. Meshes use bytes, so that the driver runs the same
    // code as for the picture.
    probe.options.floatPixels = !from.noise.empty();
    probe.options.alpha = false;
    Stats stats;
    const auto picture = [&](const budget::Choice& choice) -> Result<image::Image> {
        scene::Scene chosen = scene;
        budget::apply(choice, chosen);
        probe.options.samples = choice.samples;
        auto loaded =
            SceneState::load(context, {std::move(chosen), nullptr, {}}, probe.options, stats, parts);
        if (!loaded) return std::move(loaded.diagnostics);
        (*loaded)->view = view;
        return (*loaded)->draw(options.time, stats);
    };
    const Result<image::Image> before = picture(from), after = picture(to);
    if (!before || !after) return std::nullopt;
    return budget::ContourShifts(*before, *after, probe.shrink);
}

}  // namespace glibra::render
