#pragma once

#include <glibra/render.h>

namespace glibra::render {

struct ProbeOptions {
    RenderOptions options;
    double shrink = 1;  ///< pixels of the picture per pixel of the probe, along one side; at least 1
};

/// Options for a small picture that is measured and not shown: of the same aspect, at most `largestSide`
/// pixels per side, with one sample, without error bound, tiles, axes and warnings.
ProbeOptions probeOptions(const RenderOptions& options, int width, int height, int largestSide);

}  // namespace glibra::render
