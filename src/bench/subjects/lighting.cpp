#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <tuple>

#include "bench/core/device.h"
#include "bench/reference/lighting.h"
#include "bench/subjects/subjects.h"
#include "embedded/bench_shaders.h"
#include "geometry/shapes/cylinders.h"
#include "geometry/shapes/spheres.h"

namespace glibra::bench {
namespace {

constexpr double kExponent = 32;
constexpr double kSeen = 1.05;  ///< half the side of the square of eye space that a picture of a mesh shows

Shader highlightShader(Bench& bench, const char* cosine) {
    return {bench, fmt::format("#define COSINE {}\n{}", cosine, bench_shaders::highlight_frag())};
}
constexpr const char* kReflection = "reflect(-uLight, n).z";
constexpr const char* kHalfVector = "dot(n, normalize(uLight + vec3(0., 0., 1.)))";

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();  ///< where a pixel shows no surface

/// The first component of each pixel of a canvas whose second one is 1 on the surface.
std::vector<double> surfaceOf(const Canvas& canvas) {
    const std::vector<float> drawn = canvas.pixels(2);
    std::vector<double> values;
    for (std::size_t i = 0; i < drawn.size(); i += 2)
        values.push_back(drawn[i + 1] < .5F ? kNothing : static_cast<double>(drawn[i]));
    return values;
}

/// A value of the normal at each pixel that shows the surface, in a picture that reaches to `seen` in x and
/// y.
template <class Value>
std::vector<double> wantedOf(LitSurface surface, int side, double seen, const Value& value) {
    return overPixels(side, side, [&](double x, double y) {
        const auto normal = normalAt(surface, seen * (2 * x - 1), seen * (2 * y - 1));
        return normal ? value(*normal) : kNothing;
    });
}

/// The largest value at a pixel that both pictures cover.
double brightest(const std::vector<double>& picture, const std::vector<double>& other) {
    double most = 0;
    for (std::size_t i = 0; i < picture.size(); ++i)
        if (!std::isnan(other[i]) && !std::isnan(picture[i])) most = std::max(most, picture[i]);
    return most;
}

Figure surfaceFigure(Bench& bench, LitSurface surface) {
    const bool isSphere = surface == LitSurface::sphere;
    // Neither along the view nor in a plane of symmetry.
    const glm::dvec3 light = glm::normalize(glm::dvec3(.5, .7, 1));
    Figure figure{
        .name = isSphere ? "sphere" : "torus",
        .title = isSphere ? "Lit sphere: by vertex and by fragment" : "Lit torus: by vertex and by fragment",
        .settingName = "slices",
        .errorName = "root mean square over the pixels",
        .errorUnit = "of full intensity",
        .reference =
            "Phong lighting in double at the point of the analytic surface that each pixel's ray "
            "meets; no mesh, no interpolation"};
    const int side = bench.pick(96, 384), most = bench.pick(64, 512);
    const std::vector<double> wanted = wantedOf(surface, side, kSeen, [&](const glm::dvec3& normal) {
        return intensity(Highlight::reflection, normal, light, kExponent);
    });
    const Canvas canvas(bench, side, side, gpu::TexelFormat::rgba32f);
    const std::pair<const char*, const char*> methods[] = {
        {"per vertex (Gouraud)", "vIntensity"},
        {"per fragment, normals as interpolated", "intensity(vNormal)"},
        {"per fragment, normals renormalised", "intensity(normalize(vNormal))"},
        {"per fragment, analytic normals",
         isSphere ? "intensity(normalize(uToEye * vModel))"
                  : "intensity(uToEye * normalize(vModel - vec3(normalize(vModel.xy) * uRing, 0.)))"}};
    for (const auto& [name, expression] : methods) {
        const Shader shader(bench,
                            fmt::format("{}{}", bench_shaders::phong_glsl(), bench_shaders::lit_mesh_vert()),
                            fmt::format("#define INTENSITY {}\n{}{}", expression, bench_shaders::phong_glsl(),
                                        bench_shaders::lit_mesh_frag()));
        shader.set("uToEye", isSphere ? glm::mat3(1) : glm::mat3(torusRotation()))
            .set("uScale", 1 / kSeen)
            .set("uRing", kRingRadius)
            .set("uExponent", kExponent)
            .set("uLight", glm::vec3(light));
        for (int slices = 8; slices <= most; slices *= 2) {
            const Vertices mesh(isSphere ? geometry::sphere(1, slices, slices / 2)
                                         : geometry::torus(kRingRadius, kTubeRadius, slices / 2, slices),
                                true);
            const Timing time = bench.timeDrawing([&] {
                canvas.clear();
                glEnable(GL_DEPTH_TEST);
                mesh.draw(shader);
                glDisable(GL_DEPTH_TEST);
            });
            const std::vector<double> drawn = surfaceOf(canvas);
            figure.add(name, {1. * slices, fmt::format("{} slices", slices), rootMeanSquare(drawn, wanted),
                              time, mesh.bytes()});
            if (slices == 16)
                figure.note("{}: with 16 slices the brightest pixel is {:.3f}, exactly {:.3f}", name,
                            brightest(drawn, wanted), brightest(wanted, drawn));
        }
        figure.findings.push_back(orderSentence(figure.curves.back(), "slices"));
    }
    return figure;
}

/// Highlights alone over the sphere drawn as a rectangle, compared with those of the reflection.
class HighlightPicture {
  public:
    /// The light is at that angle (degrees) to the view, tilted so that no row or column is special.
    HighlightPicture(Bench& bench, int side, double angle, double exponent)
        : canvas_(bench, side, side, gpu::TexelFormat::rgba32f) {
        const double a = angle * std::numbers::pi / 180;
        light_ = {std::sin(a) * .8, std::sin(a) * .6, std::cos(a)};
        wanted_ = wantedOf(LitSurface::sphere, side, 1, [&](const glm::dvec3& normal) {
            return highlight(Highlight::reflection, normal, light_, exponent);
        });
    }
    void draw(const Shader& shader) const {
        canvas_.bind();
        shader.draw();
    }
    /// The root mean square of the differences.
    [[nodiscard]] double error(const Shader& shader, double exponent) const {
        shader.set("uLight", glm::vec3(light_)).set("uExponent", exponent);
        draw(shader);
        return rootMeanSquare(surfaceOf(canvas_), wanted_);
    }
    [[nodiscard]] double bytes() const { return canvas_.bytes(); }

  private:
    Canvas canvas_;
    glm::dvec3 light_;
    std::vector<double> wanted_;
};

Figure halfVectorFigure(Bench& bench) {
    Figure figure{.name = "half-vector",
                  .title = "Highlight by the half vector: which exponent matches the reflection",
                  .settingName = "factor on the exponent",
                  .errorName = "root mean square over the sphere",
                  .errorUnit = "of the highlight",
                  .reference = "the reflection's highlight in double on the analytic sphere",
                  .alternatives = Alternatives::none};
    const int stepsAUnit = bench.pick(2, 8);
    const Shader half = highlightShader(bench, kHalfVector);
    for (const double angle : {20., 90.})
        for (const double exponent : {8., 32., 128.}) {
            const HighlightPicture picture(bench, bench.pick(64, 192), angle, exponent);
            const std::string name = fmt::format("exponent {}, light at {} degrees", exponent, angle);
            for (int i = 0; i <= 5 * stepsAUnit; ++i) {
                const double factor = 1 + static_cast<double>(i) / stepsAUnit;
                figure.add(name, {factor, fmt::format("{} times", factor),
                                  picture.error(half, exponent * factor), std::nullopt, picture.bytes()});
            }
            const Curve& curve = figure.curves.back();
            const auto best = std::ranges::min_element(curve.points, {}, &Point::error);
            figure.note("{}: a factor of {} is best; {} remains, {} with the exponent unchanged", curve.name,
                        best->setting, numberText(best->error), numberText(curve.points.front().error));
        }
    return figure;
}

Figure modelFigure(Bench& bench) {
    Figure figure{.name = "highlight-models",
                  .title = "Reflection and half vector by the angle of the light, exponent 32",
                  .settingName = "angle between light and view, degrees",
                  .errorName = "root mean square over the sphere",
                  .errorUnit = "of the highlight",
                  .reference = "the reflection's highlight in double on the analytic sphere",
                  .alternatives = Alternatives::setting};
    const Shader reflection = highlightShader(bench, kReflection), half = highlightShader(bench, kHalfVector);
    const std::tuple<const char*, Shader, double> rows[] = {
        {"reflection", reflection, 1}, {"half vector", half, 1}, {"half vector, exponent times 4", half, 4}};
    for (const auto& [name, shader, factor] : rows)
        for (const double angle : {10., 30., 50., 70., 90., 110., 130., 150.}) {
            const HighlightPicture picture(bench, bench.pick(64, 256), angle, kExponent);
            const double error = picture.error(shader, kExponent * factor);
            figure.add(name, {angle, fmt::format("{} degrees", angle), error,
                              bench.timeDrawing([&] { picture.draw(shader); }), picture.bytes()});
        }
    const auto medianOf = [&](std::size_t curve) { return figure.curves[curve].points[1].time->median; };
    figure.note("a frame by the half vector takes {:.2f} times that by reflection",
                medianOf(1) / medianOf(0));
    return figure;
}

}  // namespace

std::vector<Figure> measureLighting(Bench& bench) {
    return {surfaceFigure(bench, LitSurface::sphere), surfaceFigure(bench, LitSurface::torus),
            halfVectorFigure(bench), modelFigure(bench)};
}

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
