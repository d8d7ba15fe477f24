#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <tuple>

#include "bench/core/device.h"
#include "bench/reference/lit_surface.h"
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

}  // namespace glibra::bench
