#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "bench/core/fit.h"
#include "bench/draw/offscreen.h"
#include "bench/reference/volume_field.h"
#include "bench/subjects/subjects.h"
#include "gpu/object/sampler.h"
#include "gpu/object/texture.h"

namespace glibra::bench {
namespace {

constexpr int kBlockSide = 4;  ///< texels

/// What a ray caster does besides adding up.
struct Casting {
    std::string name;
    double offset = .5;       ///< where in a step the field is sampled: 0 at its start, .5 in its middle
    bool isLinear = false;    ///< the opacity of a step is strength * density * length, not 1 - exp(-...)
    double threshold = 0;     ///< a ray ends when its transmittance falls below
    bool skipsEmpty = false;  ///< jumps over empty blocks
};

constexpr std::string_view kLoop = R"(
in vec2 vPlace;
uniform sampler3D uField;
uniform sampler3D uBlocks;
uniform vec3 uRight;
uniform vec3 uUp;
uniform vec3 uDirection;
uniform float uSeen;
uniform float uStrength;
uniform float uSteps;
uniform float uBlockCount;
out vec4 fColor;
void main() {
    vec2 place = (vPlace * 2. - 1.) * uSeen;
    vec3 origin = vec3(.5) + place.x * uRight + place.y * uUp;
    vec3 a = -origin / uDirection;
    vec3 b = (1. - origin) / uDirection;
    vec3 low = min(a, b);
    vec3 high = max(a, b);
    float enter = max(low.x, max(low.y, low.z));
    float leave = min(high.x, min(high.y, high.z));
    fColor = vec4(0.);
    if (enter >= leave)
        return;
    int count = max(1, int(ceil((leave - enter) * uSteps / sqrt(3.))));
    float stepLength = (leave - enter) / float(count);
    float light = 0.;
    float transmittance = 1.;
    for (int i = 0; i < count; ++i) {
        vec3 p = origin + (enter + (float(i) + OFFSET) * stepLength) * uDirection;
SKIP
        float density = texture(uField, p).r;
        float kept = KEPT;
        light += transmittance * (1. - kept) * (.2 + .8 * density);
        transmittance *= kept;
STOP
    }
    fColor = vec4(light, 1. - transmittance, 0., 1.);
}
)";

/// The other samples keep their places. Only samples that are certainly in the empty block are skipped: up to
/// one before its border, because the border is computed in float.
constexpr std::string_view kSkip = R"(
        vec3 cell = floor(p * uBlockCount);
        if (texelFetch(uBlocks, clamp(ivec3(cell), ivec3(0), ivec3(int(uBlockCount) - 1)), 0).r == 0.) {
            vec3 border = (cell + step(vec3(0.), uDirection)) / uBlockCount;
            vec3 there = (border - p) / uDirection;
            i += max(int(min(there.x, min(there.y, there.z)) / stepLength) - 1, 0);
            continue;
        }
)";

std::string replaced(std::string text, std::string_view word, std::string_view by) {
    const std::size_t at = text.find(word);
    return text.replace(at, word.size(), by);
}

std::string fragmentOf(const Casting& casting) {
    std::string text = replaced(std::string(kLoop), "OFFSET", fmt::format("{:.1f}", casting.offset));
    text = replaced(text, "SKIP", casting.skipsEmpty ? kSkip : "");
    text = replaced(text, "KEPT",
                    casting.isLinear ? "max(1. - uStrength * density * stepLength, 0.)"
                                     : "exp(-uStrength * density * stepLength)");
    return replaced(text, "STOP",
                    casting.threshold > 0
                        ? fmt::format("        if (transmittance < {:.9f}) break;\n", casting.threshold)
                        : "");
}

/// The field and its blocks on the device, and the target.
struct Volume {
    VolumeField field;
    gpu::Texture texels, blocks;
    gpu::Sampler linear{gpu::Wrap::clampToEdge};
    gpu::Target target;

    /// Bytes of the texels and the picture, and of the blocks if they are read.
    [[nodiscard]] double bytes(bool withBlocks) const {
        const auto cube = [](const gpu::Texture& texture) {
            return std::pow(texture.size().width, 3) * static_cast<double>(sizeof(float));
        };
        const double picture = static_cast<double>(target.width()) * target.height() * 4 * sizeof(float);
        return cube(texels) + (withBlocks ? cube(blocks) : 0) + picture;
    }
};

Result<gpu::Texture> upload(const gpu::Capabilities& capabilities, const VolumeField& field) {
    return gpu::Texture::create(
        capabilities, gpu::TextureShape::texture3D, gpu::TexelFormat::r32f,
        {field.side, field.side, field.side},
        {std::as_bytes(std::span<const float>(field.texels)), 1, gpu::TexelType::f32});
}

Result<Volume> makeVolume(const gpu::Capabilities& capabilities, int side, int pictureSide) {
    VolumeField field = blobs(side);
    Result<gpu::Texture> texels = upload(capabilities, field);
    if (!texels) return std::move(texels.diagnostics);
    Result<gpu::Texture> blocks = upload(capabilities, blockMaxima(field, kBlockSide));
    if (!blocks) return std::move(blocks.diagnostics);
    Result<gpu::Target> target =
        gpu::Target::window(capabilities, pictureSide, pictureSide, gpu::TexelFormat::rgba32f);
    if (!target) return std::move(target.diagnostics);
    return Volume{.field = std::move(field),
                  .texels = std::move(*texels),
                  .blocks = std::move(*blocks),
                  .target = std::move(*target)};
}

void setVolumeView(const gpu::Program& program, const Volume& volume) {
    const VolumeView view = volumeView();
    setVector(program, "uRight", view.right);
    setVector(program, "uUp", view.up);
    setVector(program, "uDirection", view.direction);
    setFloats(program, "uSeen", {static_cast<float>(kVolumeSeen)});
    setFloats(program, "uBlockCount", {static_cast<float>(volume.blocks.size().width)});
    setInt(program, "uField", 0);
    setInt(program, "uBlocks", 1);
}

void draw(const Volume& volume, const gpu::Program& program) {
    volume.target.bind();
    volume.texels.bind(0);
    volume.linear.bind(0);
    volume.blocks.bind(1);
    drawWhole(program);
    glFinish();
    glBindSampler(0, 0);
}

/// Light and opacity of every pixel, top row first.
std::vector<float> volumeReference(const Volume& volume, double strength, int steps) {
    const int side = volume.target.width();
    std::vector<float> values;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const auto ray = volumeRay((2 * column + 1.0) / side - 1, 1 - (2 * row + 1.0) / side);
            const VolumeLight light = ray ? integrate(volume.field, *ray, strength, steps) : VolumeLight{};
            values.push_back(static_cast<float>(light.light));
            values.push_back(static_cast<float>(light.opacity));
        }
    return values;
}

double volumeError(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
        sum += difference * difference;
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Draws once for the picture, then repeatedly for the time.
Result<Point> measureVolumePoint(Bench& bench, const gpu::Capabilities& capabilities, const Volume& volume,
                                 const gpu::Program& program, const std::vector<float>& wanted,
                                 std::vector<float>* kept = nullptr) {
    draw(volume, program);
    Result<std::vector<float>> drawn = readFloats(capabilities, volume.target, 2);
    if (!drawn) return std::move(drawn.diagnostics);
    Point point;
    point.error = volumeError(*drawn, wanted);
    point.time = bench.time([&] { draw(volume, program); });
    if (kept) *kept = std::move(*drawn);
    return point;
}

Result<Figure> stepsFigure(Bench& bench, const gpu::Capabilities& capabilities, const Volume& volume) {
    constexpr double kStrength = 40;
    Figure figure{
        .name = "steps",
        .title = "Volume ray casting: steps, and what can be left out",
        .settingName = "steps a diagonal",
        .errorName = "root mean square of light and opacity",
        .errorUnit = "",
        .reference = "midpoint rule in double with many more steps over the same texels, filtered in double"};
    const int most = bench.isQuick() ? 128 : 1024;
    const std::vector<float> wanted = volumeReference(volume, kStrength, 8 * most);
    const std::vector<Casting> castings{{.name = "all steps"},
                                        {.name = "sampled at the start of each step", .offset = 0},
                                        {.name = "opacity of a step linear in its length", .isLinear = true},
                                        {.name = "ends below 1/100 of the light", .threshold = .01},
                                        {.name = "skips empty blocks", .skipsEmpty = true},
                                        {.name = "skips and ends", .threshold = .01, .skipsEmpty = true}};
    std::vector<float> plain, skipping;
    for (const Casting& casting : castings) {
        Result<gpu::Program> program = bench::program(capabilities, kWholeTarget, fragmentOf(casting));
        if (!program) return std::move(program.diagnostics);
        setVolumeView(*program, volume);
        setFloats(*program, "uStrength", {static_cast<float>(kStrength)});
        Curve curve{.name = casting.name};
        for (int steps = 8; steps <= most; steps *= 2) {
            setFloats(*program, "uSteps", {static_cast<float>(steps)});
            std::vector<float>* kept = casting.name == "all steps"            ? &plain
                                       : casting.name == "skips empty blocks" ? &skipping
                                                                              : nullptr;
            Result<Point> point = measureVolumePoint(bench, capabilities, volume, *program, wanted, kept);
            if (!point) return std::move(point.diagnostics);
            point->setting = steps;
            point->label = fmt::format("{} steps", steps);
            point->memory = volume.bytes(casting.skipsEmpty);
            curve.points.push_back(std::move(*point));
        }
        figure.findings.push_back(orderSentence(curve, "steps", 16, 256));
        figure.curves.push_back(std::move(curve));
    }
    const auto timeOf = [&](std::size_t curve) { return figure.curves[curve].points.back().time->median; };
    for (std::size_t i = 3; i < castings.size(); ++i)
        figure.findings.push_back(fmt::format(
            "{}: with {} steps a frame takes {:.2f} of the time, and the error is {} "
            "instead of {}",
            castings[i].name, most, timeOf(i) / timeOf(0), numberText(figure.curves[i].points.back().error),
            numberText(figure.curves[0].points.back().error)));
    const auto differing = std::ranges::count_if(
        plain, [&, i = std::size_t{0}](float value) mutable { return value != skipping[i++]; });
    figure.findings.push_back(fmt::format("skipping empty blocks changes {} of {} numbers of the picture",
                                          differing, plain.size()));
    return figure;
}

Result<Figure> terminationFigure(Bench& bench, const gpu::Capabilities& capabilities, const Volume& volume) {
    Figure figure{.name = "termination",
                  .title = "Volume ray casting: where a ray may end",
                  .settingName = "transmittance at the end of a ray",
                  .errorName = "root mean square of light and opacity",
                  .errorUnit = "",
                  .reference = "the same steps to the end of every ray, on the same driver",
                  .alternatives = Alternatives::curve};
    const float steps = bench.isQuick() ? 128 : 512;
    const auto prepared = [&](double threshold, double strength) {
        Result<gpu::Program> program =
            bench::program(capabilities, kWholeTarget,
                           fragmentOf({.name = "", .threshold = threshold, .skipsEmpty = false}));
        if (program) {
            setVolumeView(*program, volume);
            setFloats(*program, "uStrength", {static_cast<float>(strength)});
            setFloats(*program, "uSteps", {steps});
        }
        return program;
    };
    for (const double strength : {10., 40., 160.}) {
        Result<gpu::Program> whole = prepared(0, strength);
        if (!whole) return std::move(whole.diagnostics);
        draw(volume, *whole);
        const Result<std::vector<float>> wanted = readFloats(capabilities, volume.target, 2);
        if (!wanted) return wanted.diagnostics;
        const Timing wholeTime = bench.time([&] { draw(volume, *whole); });
        Curve curve{.name = fmt::format("extinction {}", strength)};
        for (const double threshold : {.5, .2, .1, .05, .02, .01, .005, .002, .001, .0001}) {
            Result<gpu::Program> program = prepared(threshold, strength);
            if (!program) return std::move(program.diagnostics);
            Result<Point> point = measureVolumePoint(bench, capabilities, volume, *program, *wanted);
            if (!point) return std::move(point.diagnostics);
            point->setting = threshold;
            point->label = fmt::format("below {}", threshold);
            point->memory = volume.bytes(false);
            if (threshold == .01)
                figure.findings.push_back(fmt::format(
                    "{}: ending below 1/100 takes {:.2f} of the time for an error of {}", curve.name,
                    point->time->median / wholeTime.median, numberText(point->error)));
            curve.points.push_back(std::move(*point));
        }
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

}  // namespace

Result<std::vector<Figure>> measureVolume(Bench& bench) {
    const Result<gpu::Context*> context = bench.context();
    if (!context) return context.diagnostics;
    const gpu::Capabilities& capabilities = (*context)->capabilities();
    Result<Volume> volume = makeVolume(capabilities, bench.isQuick() ? 32 : 64, bench.isQuick() ? 48 : 128);
    if (!volume) return std::move(volume.diagnostics);
    return measureEach({stepsFigure, terminationFigure}, bench, capabilities, *volume);
}

}  // namespace glibra::bench
