#pragma once

#include <glibra/render.h>

#include <vector>

namespace glibra::render {

struct ProbeOptions {
    RenderOptions options;
    double shrink = 1;  ///< pixels of the picture per pixel of the probe, along one side; at least 1
};

/// Options for a small picture that is measured and not shown: of the same aspect, at most `largestSide`
/// pixels per side, with one sample, without error bound, tiles, axes and warnings.
ProbeOptions probeOptions(const RenderOptions& options, int width, int height, int largestSide);

/// The moments (seconds) at which a scene is measured: that of the picture, or the beginning, the middle and
/// the end of an animation.
std::vector<double> momentsOf(const RenderOptions& options);

}  // namespace glibra::render
