#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "bench/core/device.h"
#include "bench/core/run.h"
#include "bench/reference/filtering.h"
#include "bench/subjects/subjects.h"
#include "embedded/bench_shaders.h"
#include "noise/tables.h"

namespace glibra::bench {
namespace {

constexpr int kNoiseSide = 256;
constexpr const char* kNoiseReference = "the noise function itself, in double";
constexpr const NoiseFormat& kCutOff = kNoiseFormats[0];
constexpr const NoiseFormat& kRounded = kNoiseFormats[1];
constexpr const NoiseFormat& kFloat = kNoiseFormats[4];

// One octave; {0} is the number of cells, {1} and {2} are the permutations, {3} the gradients.
constexpr std::string_view kOctave = R"(const int kOuter{0}[{0}] = int[{0}]({1});
const int kInner{0}[{0}] = int[{0}]({2});
const vec3 kGradients{0}[{0}] = vec3[{0}]({3});
float noise{0}(vec3 place) {{
    vec3 lattice = place * {0}., cell = floor(lattice), t = lattice - cell;
    vec3 n0 = 1. + t * t * t * (-10. + t * (15. - 6. * t)), n1 = 1. - n0;
    vec3 g0 = t * (1. + t * t * (-6. + t * (8. - 3. * t))), g1 = t * t * t * (-4. + t * (7. - 3. * t));
    ivec3 near = ivec3(cell);
    float sum = .5;
    for (int corner = 0; corner < 8; ++corner) {{
        ivec3 step = ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
        ivec3 at = (near + step) & {4};
        vec3 gradient = kGradients{0}[(at.x + kOuter{0}[(at.y + kInner{0}[at.z]) & {4}]) & {4}];
        vec3 level = mix(n0, n1, vec3(step)), slope = mix(g0, g1, vec3(step));
        sum += gradient.x * slope.x * level.y * level.z + gradient.y * level.x * slope.y * level.z
             + gradient.z * level.x * level.y * slope.z;
    }}
    return sum;
}}
)";

/// All octaves, with the tables of noise::noise3.
std::string functionText() {
    std::string text;
    for (const noise::tables::Octave3& octave : noise::tables::kOctaves3) {
        std::vector<std::string> gradients;
        for (const std::array<double, 3>& each : octave.gradients)
            gradients.push_back(fmt::format("vec3({:.4f}, {:.4f}, {:.4f})", each[0], each[1], each[2]));
        text += fmt::format(kOctave, octave.cells, fmt::join(octave.p, ", "), fmt::join(octave.q, ", "),
                            fmt::join(gradients, ", "), octave.cells - 1);
    }
    return text + "vec4 noise(vec3 p) { return vec4(noise4(p), noise8(p), noise16(p), noise32(p)); }\n";
}

double sumOf(const Octaves& octaves) {
    return std::accumulate(octaves.begin(), octaves.end(), 0.);
}

std::vector<int> sidesOf(const Bench& bench) {
    return bench.pick(std::vector{16, 32, 64}, {16, 32, 64, 128, 256});
}

/// Exact texels by size, computed once; the largest take 268 MB.
class ExactTexels {
  public:
    const std::vector<float>& of(int side) {
        std::vector<float>& texels = bySide_[side];
        if (texels.empty()) texels = exactTexels(side);
        return texels;
    }

  private:
    std::map<int, std::vector<float>> bySide_;
};

Texels uploaded(Bench& bench, const NoiseVolume& volume) {
    const auto made = [&](const auto& values) {
        const int n = volume.side();
        Texels texels(bench, volume.format().texels, {n, n, n}, values, noise::kOctaves);
        return texels.sampledBy({.border = {}});
    };
    const double steps = volume.format().steps;
    const auto integers = [&](auto values) {
        for (const float each : volume.values())
            values.push_back(static_cast<decltype(values)::value_type>(std::lround(each * steps)));
        return made(values);
    };
    return steps == 0     ? made(volume.values())
           : steps == 255 ? integers(std::vector<std::uint8_t>())
                          : integers(std::vector<std::uint16_t>());
}

Point pointOf(const NoiseVolume& volume, double error, std::optional<Timing> time) {
    return {1. * volume.side(), fmt::format("{0} x {0} x {0}", volume.side()), error, time,
            std::pow(volume.side(), 3) * static_cast<double>(gpu::bytesPerTexel(volume.format().texels))};
}

/// Interpolates on the CPU, for the sum and for each octave.
std::vector<Figure> onCpu(const Bench& bench, ExactTexels& exact) {
    Figure sum{.name = "texels",
               .title = "Noise texture: sum of four octaves, interpolated in double (time: 4096 places)",
               .settingName = "texels per side",
               .errorName = "root mean square error",
               .errorUnit = "1/255",
               .reference = kNoiseReference};
    Figure octaves{.name = "octaves",
                   .title = "Noise texture of floats: each octave, interpolated in double",
                   .settingName = "texels per side",
                   .errorName = "root mean square error, of the octave's own root mean square",
                   .reference = kNoiseReference,
                   .alternatives = Alternatives::curve};
    std::vector<std::pair<glm::dvec3, Octaves>> samples;
    for (int i = 0; i < 4096; ++i) samples.emplace_back(spread(i), exactNoise(spread(i)));
    Octaves strength{};
    for (const auto& [place, values] : samples)
        for (std::size_t i = 0; i < strength.size(); ++i) strength[i] += std::pow(values[i] - .5, 2);
    // The sums must be used, otherwise the compiler removes the work.
    const auto timed = [&](const auto& look) {
        return bench.time([&] {
            double kept = 0;
            for (const auto& [place, values] : samples) kept += sumOf(look(place));
            [[maybe_unused]] const volatile double all = kept;
        });
    };
    for (const int side : sidesOf(bench))
        for (const NoiseFormat& format : kNoiseFormats) {
            const NoiseVolume volume(side, format, exact.of(side));
            double error = 0;
            Octaves errors{};
            for (const auto& [place, values] : samples) {
                const Octaves found = volume.at(place);
                error += std::pow(sumOf(found) - sumOf(values), 2);
                for (std::size_t i = 0; i < errors.size(); ++i)
                    errors[i] += std::pow(found[i] - values[i], 2);
            }
            Point point = pointOf(volume, kByte * std::sqrt(error / static_cast<double>(samples.size())),
                                  timed([&](const glm::dvec3& place) { return volume.at(place); }));
            sum.add(format.name, point);
            for (std::size_t i = 0; &format == &kFloat && i < errors.size(); ++i) {
                point.error = std::sqrt(errors[i] / strength[i]);
                octaves.add(fmt::format("{} cells per period", noise::cellsOf(static_cast<int>(i))), point);
            }
        }

    for (const Curve& curve : sum.curves) {
        sum.findings.push_back(orderSentence(curve, "texels"));
        sum.note("{}: {}/255 at {}", curve.name, numberText(curve.points.back().error),
                 curve.points.back().label);
    }
    sum.note("the function itself takes {:.1f} times as long as a look-up in the largest texture",
             timed(exactNoise).median / sum.last(sum.curves.size() - 1).time->median);
    const Point &cut = curveNamed(sum, kCutOff.name).points.back(),
                &rounded = curveNamed(sum, kRounded.name).points.back();
    sum.note("rounding bytes instead of cutting them off leaves {:.0f} % of the error at {}",
             100 * rounded.error / cut.error, cut.label);
    for (int i = 0; i < noise::kOctaves; ++i) {
        const Curve& curve = octaves.curves[static_cast<std::size_t>(i)];
        const double from = 2 * noise::cellsOf(i);
        if (!std::isnan(fittedOrder(curve, from)))
            octaves.findings.push_back(orderSentence(curve, "texels", from));
    }
    for (const Point& point : octaves.curves.front().points)
        octaves.note("{:g} texels per cell leave {} of the octave wrong", point.setting / noise::cellsOf(0),
                     numberText(point.error));
    return {std::move(sum), std::move(octaves)};
}

/// A picture of the plane `corner` + x `across` + y `up` through the noise, with x and y from 0 to 1. Places
/// are in periods.
struct NoisePlane {
    glm::dvec3 corner{0}, across{1, 0, 0}, up{0, 1, 0};
    [[nodiscard]] glm::dvec3 at(double x, double y) const { return corner + x * across + y * up; }
};

/// Square pictures of planes. `source` precedes shaders/noise_plane.frag.
class NoisePicture {
  public:
    NoisePicture(Bench& bench, int side, const std::string& source = {})
        : canvas_(bench, side, side, gpu::TexelFormat::rgba32f),
          shader_(bench, source + std::string(bench_shaders::noise_plane_frag())) {}

    /// Without a texture for noise from a function.
    void draw(const NoisePlane& plane, const Texels* texture) const {
        if (texture) texture->bind(0);
        canvas_.bind();
        shader_.set("uNoise", 0)
            .set("uCorner", glm::vec3(plane.corner))
            .set("uAcross", glm::vec3(plane.across))
            .set("uUp", glm::vec3(plane.up))
            .draw();
    }
    /// Draws. The octaves of every pixel.
    [[nodiscard]] std::vector<Octaves> drawn(const NoisePlane& plane, const Texels* texture) const {
        draw(plane, texture);
        std::vector<Octaves> octaves;
        const std::vector<float> values = canvas_.pixels();
        for (std::size_t i = 0; i < values.size(); i += noise::kOctaves)
            std::copy_n(&values[i], noise::kOctaves, octaves.emplace_back().begin());
        return octaves;
    }
    /// The same from the function itself.
    [[nodiscard]] std::vector<Octaves> wanted(const NoisePlane& plane) const {
        return overPixels(canvas_.width(), canvas_.width(),
                          [&](double x, double y) { return exactNoise(plane.at(x, y)); });
    }

  private:
    Canvas canvas_;
    Shader shader_;
};

/// Times a slanted plane through one period, and measures the sum of the octaves over it.
Point drawn(const Bench& bench, const NoisePicture& picture, const NoiseVolume* volume,
            const Texels* texture) {
    const NoisePlane plane{.corner = {.013, .027, .37}, .across = {.95, .02, .11}, .up = {.03, .93, .29}};
    static const std::vector<Octaves> wanted = picture.wanted(plane);  // all pictures have one size
    const Timing time = bench.timeDrawing([&] { picture.draw(plane, texture); });
    std::vector<double> sums, wantedSums;
    std::ranges::transform(picture.drawn(plane, texture), std::back_inserter(sums), sumOf);
    std::ranges::transform(wanted, std::back_inserter(wantedSums), sumOf);
    const double error = kByte * rootMeanSquare(sums, wantedSums);
    return volume ? pointOf(*volume, error, time) : Point{1, "no texture", error, time};
}

/// The driver's filter on the bytes of scenes, for each size.
std::vector<Figure> scenesBytes(Bench& bench) {
    const NoisePicture picture(bench, kNoiseSide);
    Figure figure;
    for (const int side : sidesOf(bench)) {
        const NoiseVolume volume(side, kCutOff, {});
        const Texels texture = uploaded(bench, volume);
        figure.add("filtered in bytes", drawn(bench, picture, &volume, &texture));
    }
    return {figure};
}

Figure onDevice(Bench& bench, ExactTexels& exact) {
    Figure figure{
        .name = "drawn",
        .title = fmt::format("Noise in a picture of {0} x {0} pixels, sum of four octaves", kNoiseSide),
        .settingName = "texels per side",
        .errorName = "root mean square error",
        .errorUnit = "1/255",
        .reference = kNoiseReference};
    const NoisePicture byDriver(bench, kNoiseSide), byShader(bench, kNoiseSide, "#define SHADER_FILTER\n"),
        byFunction(bench, kNoiseSide, "#define FUNCTION\n" + functionText());
    for (const int side : sidesOf(bench))
        for (const NoiseFormat& format : kNoiseFormats) {
            const NoiseVolume volume(side, format, exact.of(side));
            const Texels texture = uploaded(bench, volume);
            figure.add(fmt::format("driver's filter, {}", format.name),
                       drawn(bench, byDriver, &volume, &texture));
            if (&format == &kFloat)
                figure.add("shader's filter, float", drawn(bench, byShader, &volume, &texture));
        }
    figure.add("function in the shader", drawn(bench, byFunction, nullptr, nullptr));
    const auto last = [&](std::string_view curve) { return curveNamed(figure, curve).points.back(); };
    const Point driver = last("driver's filter, float"), shader = last("shader's filter, float"),
                function = last("function in the shader"), bytes = last("driver's filter, 8 bit, cut off");
    figure.note(
        "{}: filtering in the shader takes {:.2f} times as long as the driver's filter, the function itself "
        "{:.2f} times",
        driver.label, shader.time->median / driver.time->median, function.time->median / driver.time->median);
    figure.note("the function in the shader is within {}/255 of the one in double",
                numberText(function.error));
    if (std::optional<std::vector<Point>> points = filteredInBytes(bench, scenesBytes)) {
        const Point& fast = points->back();
        figure.note(
            "{}: filtering bytes with byte arithmetic takes {:.2f} times the time of float arithmetic, with "
            "{} instead of {}/255",
            fast.label, fast.time->median / bytes.time->median, numberText(fast.error),
            numberText(bytes.error));
        figure.curves.push_back({"driver's filter in bytes, 8 bit, cut off", std::move(*points)});
    }
    return figure;
}

/// The largest error of any octave within half a texel of x = `middle`, in 255ths.
double strip(const NoisePicture& picture, const Texels& texture, double middle) {
    const double half = .5 / texture.texture().size().width;
    const NoisePlane plane{
        .corner = {middle - half, .1, .2}, .across = {2 * half, 0, 0}, .up = {0, .77, .61}};
    const std::vector<Octaves> found = picture.drawn(plane, &texture), wanted = picture.wanted(plane);
    double largest = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
        largest = std::max(largest, largestDifference(found[i], wanted[i]));
    return kByte * largest;
}

Figure seamFigure(Bench& bench, ExactTexels& exact) {
    Figure figure{.name = "seam",
                  .title = "Noise texture of floats: within half a texel of the period's border",
                  .settingName = "texels per side",
                  .errorName = "largest error of an octave",
                  .errorUnit = "1/255",
                  .reference = kNoiseReference};
    const NoisePicture picture(bench, kNoiseSide / 4);
    using enum gpu::Wrap;
    for (const int side : sidesOf(bench)) {
        const NoiseVolume volume(side, kFloat, exact.of(side));
        Texels texture = uploaded(bench, volume);
        // The last texel of a row is n - 1; the border is between it and the first texel of the next period.
        const double border = 1 - .5 / side;
        const std::tuple<const char*, gpu::Wrap, double> ways[] = {
            {"repeated", repeat, border},
            {"clamped to the edge", clampToEdge, border},
            {"mirrored", mirroredRepeat, border},
            {"repeated, in the middle", repeat, .5 - .5 / side}};
        for (const auto& [name, wrap, middle] : ways) {
            texture.sampledBy({.wrap = {wrap, wrap, wrap}, .border = {}});
            figure.add(name, pointOf(volume, strip(picture, texture, middle), std::nullopt));
        }
    }
    for (std::size_t i = 0; i < 3; ++i)
        figure.note("{}: the border's error is {:.2f} times that of the middle", figure.curves[i].name,
                    figure.last(i).error / figure.last(3).error);
    return figure;
}

}  // namespace

std::vector<Figure> measureNoise(Bench& bench) {
    (void)bench.context();
    ExactTexels exact;
    std::vector<Figure> figures = onCpu(bench, exact);
    figures.push_back(onDevice(bench, exact));
    figures.push_back(seamFigure(bench, exact));
    return figures;
}

}  // namespace glibra::bench
