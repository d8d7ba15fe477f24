#include "bench/subjects/noise.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/gtc/packing.hpp>
#include <map>
#include <numeric>
#include <tuple>

#include "bench/core/run.h"
#include "noise/tables.h"

namespace glibra::bench {
namespace {

constexpr int kNoiseSide = 256;
constexpr const char* kNoiseReference = "the noise function itself, in double";
constexpr const NoiseFormat& kCutOff = kNoiseFormats[0];
constexpr const NoiseFormat& kRounded = kNoiseFormats[1];
constexpr const NoiseFormat& kFloat = kNoiseFormats[4];

constexpr std::string_view kNoiseHead = R"(in vec2 vPlace;
uniform vec3 uCorner, uAcross, uUp;
uniform sampler3D uNoise;
out vec4 fColor;
)";
// Texel i stands for the place i / n; in the driver's coordinates it is at (i + 1/2) / n.
constexpr std::string_view kDriverFilter = R"(vec4 noise(vec3 place) {
    return texture(uNoise, place + .5 / vec3(textureSize(uNoise, 0)));
}
)";
constexpr std::string_view kShaderFilter =
    R"(vec4 texel(ivec3 at) { return texelFetch(uNoise, at & (textureSize(uNoise, 0) - 1), 0); }
vec4 row(ivec3 at, float x) { return mix(texel(at), texel(at + ivec3(1, 0, 0)), x); }
vec4 plane(ivec3 at, vec2 share) {
    return mix(row(at, share.x), row(at + ivec3(0, 1, 0), share.x), share.y);
}
vec4 noise(vec3 place) {
    vec3 texels = place * vec3(textureSize(uNoise, 0)), cell = floor(texels), share = texels - cell;
    ivec3 at = ivec3(cell);
    return mix(plane(at, share.xy), plane(at + ivec3(0, 0, 1), share.xy), share.z);
}
)";
constexpr std::string_view kNoiseMain =
    "void main() { fColor = noise(uCorner + vPlace.x * uAcross + vPlace.y * uUp); }\n";
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

std::string texelsLabel(int side) {
    return fmt::format("{0} x {0} x {0}", side);
}

Point pointOf(const NoiseVolume& volume, double error, std::optional<Timing> time) {
    return {1. * volume.side(), texelsLabel(volume.side()), error, time, volume.bytes()};
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

/// Times a slanted plane through one period, and measures the sum of the octaves over it.
Point drawn(const Bench& bench, const NoisePicture& picture, const NoiseVolume* volume,
            const Texels* texture) {
    const NoisePlane plane{.corner = {.013, .027, .37}, .across = {.95, .02, .11}, .up = {.03, .93, .29}};
    const Timing time = bench.time([&] { picture.draw(plane, texture); });
    const std::vector<float> pixels = picture.pixels();
    const float* found = pixels.data();
    double sum = 0;
    const int side = picture.side();
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column, found += noise::kOctaves) {
            const double all = std::accumulate(found, found + noise::kOctaves, 0.);
            sum += std::pow(all - sumOf(exactNoise(picture.place(plane, column, row))), 2);
        }
    const double error = kByte * std::sqrt(sum / (side * side));
    return volume ? pointOf(*volume, error, time) : Point{1, "no texture", error, time};
}

/// The driver's filter on the bytes of scenes, for each size.
std::vector<Figure> scenesBytes(Bench& bench) {
    const NoisePicture picture(bench, NoiseShader::driverFilter, kNoiseSide);
    Figure figure;
    for (const int side : sidesOf(bench)) {
        const NoiseVolume volume(side, kCutOff, {});
        const Texels texture = volume.upload(bench);
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
    const NoisePicture byDriver(bench, NoiseShader::driverFilter, kNoiseSide),
        byShader(bench, NoiseShader::shaderFilter, kNoiseSide),
        byFunction(bench, NoiseShader::function, kNoiseSide);
    for (const int side : sidesOf(bench))
        for (const NoiseFormat& format : kNoiseFormats) {
            const NoiseVolume volume(side, format, exact.of(side));
            const Texels texture = volume.upload(bench);
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
    picture.draw(plane, &texture);
    const std::vector<float> pixels = picture.pixels();
    const float* found = pixels.data();
    double largest = 0;
    for (int row = 0; row < picture.side(); ++row)
        for (int column = 0; column < picture.side(); ++column)
            for (const double wanted : exactNoise(picture.place(plane, column, row)))
                largest = std::max(largest, std::abs(*found++ - wanted));
    return kByte * largest;
}

Figure seamFigure(Bench& bench, ExactTexels& exact) {
    Figure figure{.name = "seam",
                  .title = "Noise texture of floats: within half a texel of the period's border",
                  .settingName = "texels per side",
                  .errorName = "largest error of an octave",
                  .errorUnit = "1/255",
                  .reference = kNoiseReference};
    const NoisePicture picture(bench, NoiseShader::driverFilter, kNoiseSide / 4);
    using enum gpu::Wrap;
    for (const int side : sidesOf(bench)) {
        const NoiseVolume volume(side, kFloat, exact.of(side));
        Texels texture = volume.upload(bench);
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

Octaves exactNoise(const glm::dvec3& place) {
    Octaves values{};
    for (int octave = 0; octave < noise::kOctaves; ++octave) {
        const glm::dvec3 lattice = place * static_cast<double>(noise::cellsOf(octave));
        values[static_cast<std::size_t>(octave)] = noise::noise3(lattice.x, lattice.y, lattice.z, octave);
    }
    return values;
}

std::vector<float> exactTexels(int n) {
    std::vector<float> texels;
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                for (const double each : exactNoise(glm::dvec3(x, y, z) / static_cast<double>(n)))
                    texels.push_back(static_cast<float>(each));
    return texels;
}

NoiseVolume::NoiseVolume(int n, const NoiseFormat& format, const std::vector<float>& exact)
    : n_(n), format_(format) {
    if (format.isCutOff)
        for (const std::uint8_t byte : noise::noise3Texels(n))
            values_.push_back(static_cast<float>(byte / format.steps));
    else
        for (const float value : exact)
            values_.push_back(
                format.steps > 0 ? static_cast<float>(std::round(value * format.steps) / format.steps)
                : format.texels == gpu::TexelFormat::rgba16f ? glm::unpackHalf1x16(glm::packHalf1x16(value))
                                                             : value);
}

Octaves NoiseVolume::at(const glm::dvec3& place) const {
    std::array<std::array<std::size_t, 2>, 3> index{};
    glm::dvec3 share;
    const auto side = static_cast<std::size_t>(n_);
    for (int axis = 0; axis < 3; ++axis) {
        const double texel = (place[axis] - std::floor(place[axis])) * n_;
        const auto near = static_cast<std::size_t>(texel);
        share[axis] = texel - static_cast<double>(near);
        index[static_cast<std::size_t>(axis)] = {near % side, (near + 1) % side};
    }
    Octaves sum{};
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const std::size_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        const double weight =
            (i ? share.x : 1 - share.x) * (j ? share.y : 1 - share.y) * (k ? share.z : 1 - share.z);
        const float* texel =
            values_.data() + ((index[2][k] * side + index[1][j]) * side + index[0][i]) * noise::kOctaves;
        for (std::size_t octave = 0; octave < sum.size(); ++octave) sum[octave] += weight * texel[octave];
    }
    return sum;
}

Texels NoiseVolume::upload(Bench& bench) const {
    const auto made = [&](const auto& values) {
        Texels texels(bench, format_.texels, {n_, n_, n_}, values, noise::kOctaves);
        return texels.sampledBy({.border = {}});
    };
    const auto integers = [&](auto values) {
        for (const float each : values_)
            values.push_back(static_cast<decltype(values)::value_type>(std::lround(each * format_.steps)));
        return made(values);
    };
    return format_.steps == 0     ? made(values_)
           : format_.steps == 255 ? integers(std::vector<std::uint8_t>())
                                  : integers(std::vector<std::uint16_t>());
}

double NoiseVolume::bytes() const {
    return std::pow(n_, 3) * static_cast<double>(gpu::bytesPerTexel(format_.texels));
}

glm::dvec3 spread(int i) {
    constexpr double kRoot = 1.2207440846057596;  // of x^4 = x + 1
    glm::dvec3 place(.5);
    double step = 1;
    for (int axis = 0; axis < 3; ++axis) {
        step /= kRoot;
        place[axis] += step * i;
        place[axis] -= std::floor(place[axis]);
    }
    return place;
}

NoisePicture::NoisePicture(Bench& bench, NoiseShader shader, int side)
    : canvas_(bench, side, side, gpu::TexelFormat::rgba32f),
      shader_(bench, fmt::format("{}{}{}", kNoiseHead,
                                 shader == NoiseShader::driverFilter   ? std::string(kDriverFilter)
                                 : shader == NoiseShader::shaderFilter ? std::string(kShaderFilter)
                                                                       : functionText(),
                                 kNoiseMain)) {}

void NoisePicture::draw(const NoisePlane& plane, const Texels* texture) const {
    if (texture) texture->bind(0);
    canvas_.bind();
    shader_.set("uNoise", 0)
        .set("uCorner", glm::vec3(plane.corner))
        .set("uAcross", glm::vec3(plane.across))
        .set("uUp", glm::vec3(plane.up))
        .draw();
    glFinish();
}

glm::dvec3 NoisePicture::place(const NoisePlane& plane, int column, int row) const {
    const double x = (column + .5) / side(), y = (side() - row - .5) / side();
    return plane.corner + x * plane.across + y * plane.up;
}

std::vector<Figure> measureNoise(Bench& bench) {
    (void)bench.context();
    ExactTexels exact;
    std::vector<Figure> figures = onCpu(bench, exact);
    figures.push_back(onDevice(bench, exact));
    figures.push_back(seamFigure(bench, exact));
    return figures;
}

}  // namespace glibra::bench
