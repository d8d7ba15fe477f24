#include "budget/sampling_model.h"

#include <array>
#include <cmath>

namespace glibra::budget {

double edgeError(int samples) {
    return .5 / std::sqrt(samples);
}

int leastSamples(double maxError, int most) {
    int samples = 1;
    while (edgeError(samples) > maxError && 2 * samples <= most) samples *= 2;
    return samples;
}

std::span<const int> noiseSizes(int dimensions) {
    static constexpr std::array kSizes{32, 64, 128, 256, 512, 1024};
    return std::span(kSizes).first(dimensions == 3 ? 4 : kSizes.size());
}

double noiseError(int dimensions, int size) {
    const double interpolation = (dimensions == 3 ? 17.7 : 16.8) / size / size;
    const double rounding = dimensions == 3 ? .00098 : .0015;
    return std::hypot(interpolation, rounding);
}

int leastNoiseSize(int dimensions, double pixelsPerPeriod, double maxError) {
    const std::span<const int> sizes = noiseSizes(dimensions);
    for (const int each : sizes)
        if (noiseError(dimensions, each) * pixelsPerPeriod <= maxError) return each;
    return sizes.back();
}

}  // namespace glibra::budget
