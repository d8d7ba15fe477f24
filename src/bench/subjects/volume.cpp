#include <cstddef>
#include <iterator>

#include "bench/core/device.h"
#include "bench/reference/volume_light.h"
#include "bench/subjects/subjects.h"
#include "embedded/bench_shaders.h"

namespace glibra::bench {
namespace {

constexpr int kBlockSide = 4;  ///< texels

/// What a ray caster does besides adding up, as shaders/volume.frag has it.
struct Casting {
    const char* name = "";
    std::string macros{};
};
constexpr const char* kMiddle = "#define OFFSET .5\n";
constexpr const char* kExponential = "#define KEPT exp(-uStrength * density * stepLength)\n";
constexpr const char* kSkips = "#define SKIPS\n";

std::string endingBelow(double threshold) {
    return fmt::format("{}{}#define THRESHOLD {:.9f}\n", kMiddle, kExponential, threshold);
}

/// The field and its blocks on the device, and the picture.
class VolumePicture {
  public:
    VolumePicture(Bench& bench, int side, int pictureSide)
        : bench_(bench),
          field_(blobs(side)),
          texels_(uploaded(field_)),
          blocks_(uploaded(blockMaxima(field_, kBlockSide))),
          canvas_(bench, pictureSide, pictureSide, gpu::TexelFormat::rgba32f) {}

    [[nodiscard]] Shader caster(const std::string& macros, double strength, int steps) const {
        const VolumeView view = volumeView();
        return Shader(bench_, macros + std::string(bench_shaders::volume_frag()))
            .set("uRight", glm::vec3(view.right))
            .set("uUp", glm::vec3(view.up))
            .set("uDirection", glm::vec3(view.direction))
            .set("uSeen", kVolumeSeen)
            .set("uBlockCount", 1. * blocks_.texture().size().width)
            .set("uField", 0)
            .set("uBlocks", 1)
            .set("uStrength", strength)
            .set("uSteps", 1. * steps);
    }
    /// Light and opacity of every pixel, top row first.
    [[nodiscard]] std::vector<float> drawn(const Shader& caster) const {
        draw(caster);
        return canvas_.pixels(2);
    }
    /// The time of the picture, and the bytes of the texels and the picture, and of the blocks if they are
    /// read.
    [[nodiscard]] Point point(double setting, std::string label, double error, const Shader& caster) const {
        return {setting, std::move(label), error, bench_.timeDrawing([&] { draw(caster); }),
                texels_.bytes() + (caster.has("uBlocks") ? blocks_.bytes() : 0) + canvas_.bytes()};
    }
    /// The same as drawn(), integrated in double.
    [[nodiscard]] std::vector<float> reference(double strength, int steps) const {
        std::vector<float> values;
        for (const VolumeLight& each : overPixels(canvas_.width(), canvas_.width(), [&](double x, double y) {
                 const auto ray = volumeRay(2 * x - 1, 2 * y - 1);
                 return ray ? integrate(field_, *ray, strength, steps) : VolumeLight{};
             }))
            for (const double value : {each.light, each.opacity}) values.push_back(static_cast<float>(value));
        return values;
    }

  private:
    [[nodiscard]] Texels uploaded(const VolumeField& field) const {
        return {bench_, gpu::TexelFormat::r32f, {field.side, field.side, field.side}, field.texels};
    }
    void draw(const Shader& caster) const {
        canvas_.bind();
        texels_.bind(0);
        blocks_.bind(1);
        caster.draw();
    }
    Bench& bench_;
    VolumeField field_;
    Texels texels_, blocks_;
    Canvas canvas_;
};

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
    const std::string plain = std::string(kMiddle) + kExponential;
    const Casting castings[] = {
        {"all steps", plain},
        {"sampled at the start of each step", "#define OFFSET 0.\n" + std::string(kExponential)},
        {"opacity of a step linear in its length",
         std::string(kMiddle) + "#define KEPT max(1. - uStrength * density * stepLength, 0.)\n"},
        {"ends below 1/100 of the light", endingBelow(.01)},
        {"skips empty blocks", plain + kSkips},
        {"skips and ends", endingBelow(.01) + kSkips}};
    std::vector<std::vector<float>> finest;
    for (const Casting& casting : castings) {
        const Shader caster = picture.caster(casting.macros, kStrength, 1);
        std::vector<float> drawn;
        for (int steps = 8; steps <= most; steps *= 2) {
            drawn = picture.drawn(caster.set("uSteps", 1. * steps));
            figure.add(casting.name, picture.point(steps, fmt::format("{} steps", steps),
                                                   rootMeanSquare(drawn, wanted), caster));
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
        const Shader whole = picture.caster(std::string(kMiddle) + kExponential, strength, steps);
        const std::vector<float> wanted = picture.drawn(whole);
        const Point all = picture.point(0, "", 0, whole);
        const std::string name = fmt::format("extinction {}", strength);
        for (const double threshold : {.5, .2, .1, .05, .02, .01, .005, .002, .001, .0001}) {
            const Shader caster = picture.caster(endingBelow(threshold), strength, steps);
            figure.add(name, picture.point(threshold, fmt::format("below {}", threshold),
                                           rootMeanSquare(picture.drawn(caster), wanted), caster));
            const Point& point = figure.curves.back().points.back();
            if (threshold == .01)
                figure.note("{}: ending below 1/100 takes {:.2f} of the time for an error of {}", name,
                            point.time->median / all.time->median, numberText(point.error));
        }
    }
    return figure;
}

}  // namespace

std::vector<Figure> measureVolume(Bench& bench) {
    const VolumePicture picture(bench, bench.pick(32, 64), bench.pick(48, 128));
    return {stepsFigure(bench, picture), terminationFigure(bench, picture)};
}

}  // namespace glibra::bench
