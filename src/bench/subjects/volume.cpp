#include "bench/subjects/volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <numbers>

#include "bench/core/device.h"

namespace glibra::bench {
namespace {

constexpr int kBlockSide = 4;  ///< texels

/// What a ray caster does besides adding up.
struct Casting {
    const char* name = "";
    double offset = .5;       ///< where in a step the field is sampled: 0 at its start, .5 in its middle
    bool isLinear = false;    ///< the opacity of a step is strength * density * length, not 1 - exp(-...)
    double threshold = 0;     ///< a ray ends when its transmittance falls below
    bool skipsEmpty = false;  ///< jumps over empty blocks
};

/// {0}: the offset, {1}: what skips, {2}: what a step lets through, {3}: what ends a ray.
constexpr std::string_view kCaster = R"(in vec2 vPlace;
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
void main() {{
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
    for (int i = 0; i < count; ++i) {{
        vec3 p = origin + (enter + (float(i) + {0:.1f}) * stepLength) * uDirection;
        {1}
        float density = texture(uField, p).r;
        float kept = {2};
        light += transmittance * (1. - kept) * (.2 + .8 * density);
        transmittance *= kept;
        {3}
    }}
    fColor = vec4(light, 1. - transmittance, 0., 1.);
}}
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

/// The field and its blocks on the device, and the picture.
class VolumePicture {
  public:
    VolumePicture(Bench& bench, int side, int pictureSide)
        : bench_(bench),
          field_(blobs(side)),
          texels_(uploaded(field_)),
          blocks_(uploaded(blockMaxima(field_, kBlockSide))),
          canvas_(bench, pictureSide, pictureSide, gpu::TexelFormat::rgba32f) {}

    [[nodiscard]] Shader caster(const Casting& casting, double strength, int steps) const {
        const Shader shader(
            bench_, fmt::format(kCaster, casting.offset, casting.skipsEmpty ? kSkip : "",
                                casting.isLinear ? "max(1. - uStrength * density * stepLength, 0.)"
                                                 : "exp(-uStrength * density * stepLength)",
                                casting.threshold > 0
                                    ? fmt::format("if (transmittance < {:.9f}) break;", casting.threshold)
                                    : ""));
        const VolumeView view = volumeView();
        return shader.set("uRight", glm::vec3(view.right))
            .set("uUp", glm::vec3(view.up))
            .set("uDirection", glm::vec3(view.direction))
            .set("uSeen", kVolumeSeen)
            .set("uBlockCount", 1. * blocks_.texture().size().width)
            .set("uField", 0)
            .set("uBlocks", 1)
            .set("uStrength", strength)
            .set("uSteps", 1. * steps);
    }
    void draw(const Shader& caster) const {
        canvas_.bind();
        texels_.bind(0);
        blocks_.bind(1);
        caster.draw();
    }
    /// Light and opacity of every pixel, top row first.
    [[nodiscard]] std::vector<float> drawn(const Shader& caster) const {
        draw(caster);
        return canvas_.pixels(2);
    }
    [[nodiscard]] Timing time(const Shader& caster) const {
        return bench_.timeDrawing([&] { draw(caster); });
    }
    /// The same, integrated in double.
    [[nodiscard]] std::vector<float> reference(double strength, int steps) const {
        const int side = canvas_.width();
        std::vector<float> values;
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                const auto ray = volumeRay((2 * column + 1.0) / side - 1, 1 - (2 * row + 1.0) / side);
                const VolumeLight light = ray ? integrate(field_, *ray, strength, steps) : VolumeLight{};
                values.push_back(static_cast<float>(light.light));
                values.push_back(static_cast<float>(light.opacity));
            }
        return values;
    }
    /// Bytes of the texels and the picture, and of the blocks if they are read.
    [[nodiscard]] double bytes(bool withBlocks) const {
        return texels_.bytes() + (withBlocks ? blocks_.bytes() : 0) + canvas_.bytes();
    }

  private:
    [[nodiscard]] Texels uploaded(const VolumeField& field) const {
        return {bench_, gpu::TexelFormat::r32f, {field.side, field.side, field.side}, field.texels};
    }
    Bench& bench_;
    VolumeField field_;
    Texels texels_, blocks_;
    Canvas canvas_;
};

double volumeError(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
        sum += difference * difference;
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
}

Figure stepsFigure(Bench& bench, const VolumePicture& picture) {
    constexpr double kStrength = 40;
    Figure figure{
        .name = "steps",
        .title = "Volume ray casting: steps, and what can be left out",
        .settingName = "steps a diagonal",
        .errorName = "root mean square of light and opacity",
        .reference = "midpoint rule in double with many more steps over the same texels, filtered in double"};
    const int most = bench.pick(128, 1024);
    const std::vector<float> wanted = picture.reference(kStrength, 8 * most);
    const Casting castings[] = {{.name = "all steps"},
                                {.name = "sampled at the start of each step", .offset = 0},
                                {.name = "opacity of a step linear in its length", .isLinear = true},
                                {.name = "ends below 1/100 of the light", .threshold = .01},
                                {.name = "skips empty blocks", .skipsEmpty = true},
                                {.name = "skips and ends", .threshold = .01, .skipsEmpty = true}};
    std::vector<std::vector<float>> finest;
    for (const Casting& casting : castings) {
        const Shader caster = picture.caster(casting, kStrength, 1);
        std::vector<float> drawn;
        for (int steps = 8; steps <= most; steps *= 2) {
            caster.set("uSteps", 1. * steps);
            drawn = picture.drawn(caster);
            figure.add(casting.name, {1. * steps, fmt::format("{} steps", steps), volumeError(drawn, wanted),
                                      picture.time(caster), picture.bytes(casting.skipsEmpty)});
        }
        finest.push_back(std::move(drawn));
        figure.findings.push_back(orderSentence(figure.curves.back(), "steps", 16, 256));
    }
    for (std::size_t i = 3; i < std::size(castings); ++i)
        figure.note("{}: with {} steps a frame takes {:.2f} of the time, and the error is {} instead of {}",
                    castings[i].name, most, figure.last(i).time->median / figure.last(0).time->median,
                    numberText(figure.last(i).error), numberText(figure.last(0).error));
    int differing = 0;
    for (std::size_t i = 0; i < finest[0].size(); ++i) differing += finest[0][i] != finest[4][i] ? 1 : 0;
    figure.note("skipping empty blocks changes {} of {} numbers of the picture", differing, finest[0].size());
    return figure;
}

Figure terminationFigure(Bench& bench, const VolumePicture& picture) {
    Figure figure{.name = "termination",
                  .title = "Volume ray casting: where a ray may end",
                  .settingName = "transmittance at the end of a ray",
                  .errorName = "root mean square of light and opacity",
                  .reference = "the same steps to the end of every ray, on the same driver",
                  .alternatives = Alternatives::curve};
    const int steps = bench.pick(128, 512);
    for (const double strength : {10., 40., 160.}) {
        const Shader whole = picture.caster({}, strength, steps);
        const std::vector<float> wanted = picture.drawn(whole);
        const Timing wholeTime = picture.time(whole);
        const std::string name = fmt::format("extinction {}", strength);
        for (const double threshold : {.5, .2, .1, .05, .02, .01, .005, .002, .001, .0001}) {
            const Shader caster = picture.caster({.threshold = threshold}, strength, steps);
            const double error = volumeError(picture.drawn(caster), wanted);
            const Timing time = picture.time(caster);
            figure.add(name,
                       {threshold, fmt::format("below {}", threshold), error, time, picture.bytes(false)});
            if (threshold == .01)
                figure.note("{}: ending below 1/100 takes {:.2f} of the time for an error of {}", name,
                            time.median / wholeTime.median, numberText(error));
        }
    }
    return figure;
}

/// 1 in the middle, 0 from distance 1 on, with a continuous slope.
double bump(double distance) {
    const double inside = std::max(0.0, 1 - distance * distance);
    return inside * inside;
}

double density(const glm::dvec3& p) {
    const auto from = [&](double x, double y, double z) { return glm::length(p - glm::dvec3(x, y, z)); };
    return std::min(1.0, .9 * bump(from(.3, .35, .4) / .16) + .7 * bump(from(.7, .3, .65) / .2) +
                             bump(from(.4, .75, .3) / .12) + .5 * bump((from(.65, .7, .6) - .14) / .05));
}

}  // namespace

double VolumeField::at(const glm::dvec3& p) const {
    std::array<int, 3> low{}, high{};
    glm::dvec3 t;
    for (int axis = 0; axis < 3; ++axis) {
        const double place = std::clamp(p[axis] * side - .5, 0.0, side - 1.0);
        const int texel = std::min(static_cast<int>(place), side - 1);
        low[static_cast<std::size_t>(axis)] = texel;
        high[static_cast<std::size_t>(axis)] = std::min(texel + 1, side - 1);
        t[axis] = place - texel;
    }
    const auto texel = [&](int x, int y, int z) { return static_cast<double>(texels[index(x, y, z)]); };
    const auto row = [&](int y, int z) { return std::lerp(texel(low[0], y, z), texel(high[0], y, z), t.x); };
    const auto layer = [&](int z) { return std::lerp(row(low[1], z), row(high[1], z), t.y); };
    return std::lerp(layer(low[2]), layer(high[2]), t.z);
}

VolumeField blobs(int side) {
    VolumeField field{side, {}};
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                field.texels.push_back(
                    static_cast<float>(density((glm::dvec3(x, y, z) + .5) / static_cast<double>(side))));
    return field;
}

VolumeField blockMaxima(const VolumeField& field, int blockSide) {
    VolumeField blocks{field.side / blockSide, {}};
    blocks.texels.assign(blocks.index(0, 0, blocks.side), 0);
    // At the rim of a block, the filter reads one texel beyond it.
    const auto first = [&](int block) { return std::max(block * blockSide - 1, 0); };
    const auto last = [&](int block) { return std::min((block + 1) * blockSide, field.side - 1); };
    for (int bz = 0; bz < blocks.side; ++bz)
        for (int by = 0; by < blocks.side; ++by)
            for (int bx = 0; bx < blocks.side; ++bx) {
                float& most = blocks.texels[blocks.index(bx, by, bz)];
                for (int z = first(bz); z <= last(bz); ++z)
                    for (int y = first(by); y <= last(by); ++y)
                        for (int x = first(bx); x <= last(bx); ++x)
                            most = std::max(most, field.texels[field.index(x, y, z)]);
            }
    return blocks;
}

VolumeView volumeView() {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(.45, -.3, -1));
    const glm::dvec3 right = glm::normalize(glm::cross(direction, glm::dvec3(0, 1, 0)));
    return {right, glm::cross(right, direction), direction};
}

std::optional<VolumeRay> volumeRay(double x, double y) {
    const VolumeView view = volumeView();
    VolumeRay ray{glm::dvec3(.5) + kVolumeSeen * (x * view.right + y * view.up), view.direction, -10, 10};
    for (int axis = 0; axis < 3; ++axis) {
        const double a = -ray.origin[axis] / ray.direction[axis];
        const double b = (1 - ray.origin[axis]) / ray.direction[axis];
        ray.enter = std::max(ray.enter, std::min(a, b));
        ray.leave = std::min(ray.leave, std::max(a, b));
    }
    if (ray.enter >= ray.leave) return std::nullopt;
    return ray;
}

VolumeLight integrate(const VolumeField& field, const VolumeRay& ray, double strength, int steps) {
    const double length = ray.leave - ray.enter;
    const int count = std::max(1, static_cast<int>(std::ceil(length * steps / std::numbers::sqrt3)));
    const double step = length / count;
    double light = 0, transmittance = 1;
    for (int i = 0; i < count; ++i) {
        const double density = field.at(ray.origin + (ray.enter + (i + .5) * step) * ray.direction);
        if (density == 0) continue;
        const double kept = std::exp(-strength * density * step);
        light += transmittance * (1 - kept) * (.2 + .8 * density);
        transmittance *= kept;
    }
    return {light, 1 - transmittance};
}

std::vector<Figure> measureVolume(Bench& bench) {
    const VolumePicture picture(bench, bench.pick(32, 64), bench.pick(48, 128));
    return {stepsFigure(bench, picture), terminationFigure(bench, picture)};
}

}  // namespace glibra::bench
