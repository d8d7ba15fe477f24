#include "budget/choose_noise.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "budget/pixel_text.h"

namespace glibra::budget {
namespace {

/// "64 texels per side", "64 texels per side with 16 bits"
std::string noiseText(const NoiseFormat& format) {
    return fmt::format("{} texels per side{}", format.size,
                       format.texels == scene::NoiseTexels::shorts ? " with 16 bits" : "");
}

class NoiseChooser {
  public:
    NoiseChooser(const scene::Scene& scene, const std::map<scene::TextureIndex, NoiseUse>& uses,
                 const Request& request)
        : scene_(scene), uses_(uses), request_(request) {}

    ChosenNoise choose() {
        measure();
        for (const auto& [texture, use] : uses_) {
            const scene::NoiseSource& noise = noiseOf(texture);
            if (noise.file)
                say(noise, use, "kept: its texels come from a file");
            else if (isFree(noise))
                chooseOne(texture, use);
            else
                keepStated(noise, use);
        }
        return std::move(chosen_);
    }

  private:
    [[nodiscard]] const scene::NoiseSource& noiseOf(scene::TextureIndex texture) const {
        return std::get<scene::NoiseSource>(scene_.textures[texture].source);
    }
    [[nodiscard]] bool isFree(const scene::NoiseSource& noise) const {
        return !noise.file && (!noise.isSizeGiven || request_.overrideCounts);
    }

    /// Measures on two pictures how contours move. Programs stretch noise, add octaves of their own and raise
    /// its contrast, so the contours that they draw move further than those of the noise itself.
    void measure() {
        Choice from, to;
        for (const auto& [texture, use] : uses_) {
            if (noiseOf(texture).file) continue;
            from.noise.push_back({texture, {kNoiseProbeSizes[0], scene::NoiseTexels::shorts}});
            to.noise.push_back({texture, {kNoiseProbeSizes[1], scene::NoiseTexels::shorts}});
        }
        if (!from.noise.empty() && request_.contourShift) measured_ = request_.contourShift(from, to);
    }

    /// In pixels. Changes of a value that nobody can see move nothing.
    [[nodiscard]] double errorOf(int dimensions, const NoiseFormat& format, double period) const {
        constexpr double kVisible = 4. / 255;
        const double periods = noiseError(dimensions, format);
        if (!measured_) return periods * period;
        const double step = meanNoiseStep(dimensions);
        // The largest change in a square relates to the mean as noiseError, which bounds 999 of 1000 errors,
        // relates to the mean error.
        const double largestStep = noiseError(dimensions, {kNoiseProbeSizes[1], scene::NoiseTexels::shorts});
        return measured_->ofChangesAbove(kVisible * largestStep / periods) * periods / step;
    }

    void say(const scene::NoiseSource& noise, const NoiseUse& use, std::string why) {
        chosen_.decisions.push_back(
            {fmt::format("Noise{}D", noise.dimensions), std::move(why), use.draw->place});
    }

    void miss(const scene::NoiseSource& noise, const NoiseUse& use, double pixels, int size, bool isStated) {
        chosen_.misses.push_back({pixels, use.draw, fmt::format("Noise{}D", noise.dimensions),
                                  fmt::format("{} texels per side", size), isStated});
    }

    [[nodiscard]] std::string_view sourceText() const {
        return measured_ ? ", as two pictures tell" : " if a period is one unit of the model";
    }

    void keepStated(const scene::NoiseSource& noise, const NoiseUse& use) {
        const double pixels = errorOf(noise.dimensions, {noise.size, noise.texels}, use.period);
        say(noise, use,
            fmt::format("{} as the scene states: about {}{}", noise.size, pixelText(pixels), sourceText()));
        if (pixels > request_.maxError) miss(noise, use, pixels, noise.size, true);
    }

    void chooseOne(scene::TextureIndex texture, const NoiseUse& use) {
        const scene::NoiseSource& noise = noiseOf(texture);
        const NoiseFormat before{noise.size, noise.texels};
        const auto pixelsOf = [&](const NoiseFormat& format) {
            return errorOf(noise.dimensions, format, use.period);
        };
        const NoiseFormat best = leastNoise(noise.dimensions, request_.maxError, pixelsOf);
        const double pixels = pixelsOf(best);
        if (best != before) chosen_.choices.push_back({texture, best});
        say(noise, use,
            fmt::format("{}{}: about {}{}", noiseText(best),
                        best == before ? " kept" : fmt::format(" in place of {}", noiseText(before)),
                        pixelText(pixels), sourceText()));
        if (pixels > request_.maxError) miss(noise, use, pixels, best.size, false);
    }

    const scene::Scene& scene_;
    const std::map<scene::TextureIndex, NoiseUse>& uses_;
    const Request& request_;
    std::optional<ContourShifts> measured_;
    ChosenNoise chosen_;
};

}  // namespace

ChosenNoise chooseNoise(const scene::Scene& scene, const std::map<scene::TextureIndex, NoiseUse>& uses,
                        const Request& request) {
    return NoiseChooser(scene, uses, request).choose();
}

}  // namespace glibra::budget
