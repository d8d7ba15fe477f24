#include "render/probe/probe_options.h"

#include <algorithm>
#include <cmath>

namespace glibra::render {

ProbeOptions probeOptions(const RenderOptions& options, int width, int height, int largestSide) {
    ProbeOptions probe{options, std::max(1., static_cast<double>(std::max(width, height)) / largestSide)};
    RenderOptions& small = probe.options;
    small.width = std::max(1, static_cast<int>(std::lround(width / probe.shrink)));
    small.height = std::max(1, static_cast<int>(std::lround(height / probe.shrink)));
    small.maxError = 0;
    small.samples = 1;
    small.tileSize = 0;
    small.wantedObjects.clear();
    small.labels = LabelCorner::none;
    small.axes = small.checkNan = small.strict = false;
    return probe;
}

std::vector<double> momentsOf(const RenderOptions& options) {
    if (options.lastTime <= options.time) return {options.time};
    return {options.time, (options.time + options.lastTime) / 2, options.lastTime};
}

}  // namespace glibra::render
