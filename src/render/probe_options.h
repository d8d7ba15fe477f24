#pragma once

#include <glibra/render.h>

namespace glibra::render {

struct ProbeOptions {
    RenderOptions options;
    double shrink = 1;  ///< pixels of the picture along one of the probe; at least 1
};

/// For a quick picture that is measured and not shown: no larger than `largestSide` pixels, of the same
/// shape, one sample, without bound, tiles, axes and complaints.
ProbeOptions probeOptions(const RenderOptions& options, int width, int height, int largestSide);

}  // namespace glibra::render
