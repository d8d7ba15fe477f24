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
    static constexpr std::array kSizes2{32, 64, 96, 128, 192, 256, 384, 512, 768, 1024};
    static constexpr std::array kSizes3{32, 64, 96, 128, 160, 192, 224, 256};
    return dimensions == 3 ? std::span<const int>(kSizes3) : std::span<const int>(kSizes2);
}

double noiseError(int dimensions, NoiseFormat format) {
    const double interpolation = (dimensions == 3 ? 33. : 30.) / format.size / format.size;
    double rounding = dimensions == 3 ? .0017 : .0025;
    if (format.texels == scene::NoiseTexels::shorts) rounding /= 257;
    return std::hypot(interpolation, rounding);
}

double meanNoiseStep(int dimensions) {
    return dimensions == 3 ? .0013 : .00147;
}

NoiseFormat leastNoise(int dimensions, double maxError, const std::function<double(NoiseFormat)>& errorOf) {
    const std::span<const int> sizes = noiseSizes(dimensions);
    for (const int each : sizes)
        for (const scene::NoiseTexels texels : {scene::NoiseTexels::bytes, scene::NoiseTexels::shorts})
            if (errorOf({each, texels}) <= maxError) return {each, texels};
    return {sizes.back(), scene::NoiseTexels::shorts};
}

}  // namespace glibra::budget
