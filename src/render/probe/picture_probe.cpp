#include "render/probe/picture_probe.h"

#include <algorithm>
#include <utility>

#include "render/probe/probe_options.h"

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
    const int side = largestSide(from, state.options, std::max(state.width, state.height));
    ProbeOptions probe = probeOptions(state.options, state.width, state.height, side);
    // Noise changes values by less than a byte can show. Meshes use bytes, so that the driver runs the same
    // code as for the picture.
    probe.options.floatPixels = !from.noise.empty();
    probe.options.alpha = false;
    Stats stats;
    const auto picturesOf = [&](const budget::Choice& choice) -> std::optional<std::vector<image::Image>> {
        scene::Scene chosen = state.scene;
        budget::apply(choice, chosen);
        probe.options.samples = choice.samples;
        auto loaded = SceneState::load(state.context, {std::move(chosen), state.source, state.inputs},
                                       probe.options, stats, state.parts);
        if (!loaded) return std::nullopt;
        (*loaded)->view = state.view;
        std::vector<image::Image> pictures;
        for (const double each : moments) {
            Result<image::Image> picture = (*loaded)->draw(each, stats);
            if (!picture) return std::nullopt;
            pictures.push_back(std::move(*picture));
        }
        return pictures;
    };
    const auto before = picturesOf(from), after = picturesOf(to);
    if (!before || !after) return std::nullopt;
    budget::ContourShifts shifts(before->front(), after->front(), probe.shrink);
    for (std::size_t i = 1; i < moments.size(); ++i) shifts.add((*before)[i], (*after)[i]);
    return shifts;
}

}  // namespace glibra::render
