#include "noise/noise_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "base/text.h"
#include "image/file.h"
#include "image/write.h"

namespace glibra::noise {
namespace {

template <std::size_t N, class Enumerator>
const char* wordOf(const std::array<const char*, N>& words, Enumerator value) {
    return words.at(static_cast<std::size_t>(value));
}

/// " --height 3=0.5" for each point.
std::string pointArguments(const char* name, const std::map<int, double>& points) {
    std::string text;
    for (const auto& [point, value] : points) text += fmt::format(" {} {}={}", name, point, value);
    return text;
}

bool usesSlopes(const GraphOptions& options) {
    return options.lattice == Lattice::value;
}

bool usesColors(const NoiseFile& noise, const std::filesystem::path& file) {
    return noise.options.dimensions == 2 && endingOf(file) != ".tex";
}

}  // namespace

std::string endingOf(const std::filesystem::path& file) {
    return base::lower(file.extension().generic_string());
}

Diagnostics writeNoise(const NoiseFile& noise, const std::filesystem::path& file) {
    const std::string ending = endingOf(file);
    if (ending == ".tex")
        return image::writeFileAtomically(file, noiseTexture(noise.options, noise.width, noise.height));
    if (ending == ".svg") {
        const std::string svg = graphSvg(noise.options, noise.width, noise.height);
        return image::writeFileAtomically(file, std::as_bytes(std::span(svg)));
    }
    const std::vector<std::uint8_t> pixels =
        noise.options.dimensions == 1 ? graphPixels(noise.options, noise.width, noise.height)
                                      : noisePixels(noise.options, noise.colors, noise.width, noise.height);
    image::Image picture{noise.width, noise.height, 3, image::Component::u8, {}};
    const auto bytes = std::as_bytes(std::span(pixels));
    picture.data.assign(bytes.begin(), bytes.end());
    return image::writeImage(picture, file);
}

std::string uselessOption(const NoiseFile& noise, const std::filesystem::path& file) {
    const GraphOptions& options = noise.options;
    if (!options.curvatures.empty() && options.smoothness == Smoothness::cubic)
        return "--curvature: heights and gradients determine a cubic; take --smooth quintic";
    if (options.slopes != Slopes::zero && !usesSlopes(options))
        return "--gradients: only --lattice value takes gradients from the heights";
    if (noise.colors != ColorScale::grey && !usesColors(noise, file))
        return "--colors: only a picture of two dimensions has colors";
    const int points = options.dimensions == 1 ? options.cells : options.cells * options.cells;
    for (const auto& [name, values] :
         {std::pair("--height", &options.heights), std::pair("--gradient", &options.gradients),
          std::pair("--curvature", &options.curvatures)})
        if (!values->empty() && values->rbegin()->first >= points)
            return fmt::format("{} {}={:g}: the points are 0 to {}", name, values->rbegin()->first,
                               values->rbegin()->second, points - 1);
    return {};
}

std::string noiseCommand(const NoiseFile& noise, const std::string& file) {
    const GraphOptions& options = noise.options;
    const GraphOptions usual;
    std::string text = fmt::format("glibra noise {}", options.dimensions);
    if (options.lattice != usual.lattice)
        text += fmt::format(" --lattice {}", wordOf(kLatticeWords, options.lattice));
    if (options.smoothness != usual.smoothness)
        text += fmt::format(" --smooth {}", wordOf(kSmoothnessWords, options.smoothness));
    if (options.slopes != usual.slopes && usesSlopes(options))
        text += fmt::format(" --gradients {}", wordOf(kSlopesWords, options.slopes));
    if (noise.colors != ColorScale::grey && usesColors(noise, file))
        text += fmt::format(" --colors {}", wordOf(kColorWords, noise.colors));
    if (options.octaves != usual.octaves) text += fmt::format(" --octaves {}", options.octaves);
    if (options.cells != usual.cells) text += fmt::format(" --points {}", options.cells);
    if (options.seed != usual.seed) text += fmt::format(" --seed {}", options.seed);
    if (options.turbulence) text += " --turbulence";
    text += pointArguments("--height", options.heights);
    text += pointArguments("--gradient", options.gradients);
    if (options.smoothness == Smoothness::quintic) text += pointArguments("--curvature", options.curvatures);
    return text +
           fmt::format(" --size {}x{} -o {}", noise.width, noise.height, base::shellWord(file, "/._-+"));
}

}  // namespace glibra::noise
