#include "bench/subjects/lighting.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>

#include "bench/core/device.h"
#include "geometry/shapes/cylinders.h"
#include "geometry/shapes/spheres.h"

namespace glibra::bench {
namespace {

constexpr double kExponent = 32;
constexpr double kSeen = 1.05;  ///< half the side of the square of eye space that a picture of a mesh shows

constexpr std::string_view kModel = R"(uniform vec3 uLight;
uniform float uExponent;
uniform mat3 uToEye;
float intensity(vec3 n) {
    float facing = dot(n, uLight);
    float shine = facing > 0. ? pow(max(reflect(-uLight, n).z, 0.), uExponent) : 0.;
    return .1 + .5 * max(facing, 0.) + .4 * shine;
}
)";
constexpr std::string_view kLitVertex = R"(layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
uniform float uScale;
out vec3 vModel;
out vec3 vNormal;
out float vIntensity;
void main() {
    vModel = aPosition;
    vNormal = uToEye * aNormal;
    vIntensity = intensity(vNormal);
    vec3 eye = uToEye * aPosition;
    gl_Position = vec4(eye.xy * uScale, -.5 * eye.z, 1.);
}
)";
/// Red is the intensity, for which there is a place, green is 1 on the surface.
constexpr std::string_view kLitFragment = R"(in vec3 vModel;
in vec3 vNormal;
in float vIntensity;
uniform float uRing;
out vec4 fColor;
void main() {{
    fColor = vec4({}, 1., 0., 1.);
}}
)";
/// The highlight alone on a unit sphere that fills the target.
constexpr std::string_view kHighlightFragment = R"(in vec2 vPlace;
uniform vec3 uLight;
uniform float uExponent;
out vec4 fColor;
void main() {{
    vec2 p = vPlace * 2. - 1.;
    float depth = 1. - dot(p, p);
    vec3 n = vec3(p, sqrt(max(depth, 0.)));
    float shine = dot(n, uLight) > 0. ? pow(max({}, 0.), uExponent) : 0.;
    fColor = vec4(shine, depth >= 0. ? 1. : 0., 0., 1.);
}}
)";

Shader highlightShader(Bench& bench, Highlight model) {
    return {bench, fmt::format(kHighlightFragment, model == Highlight::reflection
                                                       ? "reflect(-uLight, n).z"
                                                       : "dot(n, normalize(uLight + vec3(0., 0., 1.)))")};
}

struct Difference {
    double rootMeanSquare = 0;
    double brightest = 0, wanted = 0;  ///< largest intensity of the drawn picture and of the reference
};

/// Compares the pixels that both cover.
Difference difference(const std::vector<float>& drawn, const std::vector<std::optional<double>>& reference) {
    Difference found;
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        if (!reference[i] || drawn[2 * i + 1] < .5F) continue;
        const double value = drawn[2 * i], error = value - *reference[i];
        sum += error * error;
        ++count;
        found.brightest = std::max(found.brightest, value);
        found.wanted = std::max(found.wanted, *reference[i]);
    }
    if (count > 0) found.rootMeanSquare = std::sqrt(sum / count);
    return found;
}

/// A value of the normal at each pixel that shows the surface, in a picture that reaches to `seen` in x and
/// y.
template <class Value>
std::vector<std::optional<double>> overPixels(LitSurface surface, int side, double seen, const Value& value) {
    std::vector<std::optional<double>> values;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double x = seen * ((2 * column + 1.0) / side - 1), y = seen * (1 - (2 * row + 1.0) / side);
            const std::optional<glm::dvec3> normal = normalAt(surface, x, y);
            values.push_back(normal ? std::optional(value(*normal)) : std::nullopt);
        }
    return values;
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
    const auto wanted = overPixels(surface, side, kSeen, [&](const glm::dvec3& normal) {
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
        const Shader shader(bench, fmt::format("{}{}", kModel, kLitVertex),
                            std::string(kModel) + fmt::format(kLitFragment, expression));
        shader.set("uToEye", isSphere ? glm::mat3(1) : glm::mat3(torusRotation()))
            .set("uScale", 1 / kSeen)
            .set("uRing", kRingRadius)
            .set("uExponent", kExponent)
            .set("uLight", glm::vec3(light));
        Curve curve{.name = name};
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
            const Difference found = difference(canvas.pixels(2), wanted);
            curve.points.push_back(
                {1. * slices, fmt::format("{} slices", slices), found.rootMeanSquare, time, mesh.bytes()});
            if (slices == 16)
                figure.note("{}: with 16 slices the brightest pixel is {:.3f}, exactly {:.3f}", name,
                            found.brightest, found.wanted);
        }
        figure.findings.push_back(orderSentence(curve, "slices"));
        figure.curves.push_back(std::move(curve));
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
        wanted_ = overPixels(LitSurface::sphere, side, 1, [&](const glm::dvec3& normal) {
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
        return difference(canvas_.pixels(2), wanted_).rootMeanSquare;
    }
    [[nodiscard]] double bytes() const { return canvas_.bytes(); }

  private:
    Canvas canvas_;
    glm::dvec3 light_;
    std::vector<std::optional<double>> wanted_;
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
    const Shader half = highlightShader(bench, Highlight::halfVector);
    for (const double angle : {20., 90.})
        for (const double exponent : {8., 32., 128.}) {
            Curve curve{.name = fmt::format("exponent {}, light at {} degrees", exponent, angle)};
            const HighlightPicture picture(bench, bench.pick(64, 192), angle, exponent);
            for (int i = 0; i <= 5 * stepsAUnit; ++i) {
                const double factor = 1 + static_cast<double>(i) / stepsAUnit;
                curve.points.push_back({factor, fmt::format("{} times", factor),
                                        picture.error(half, exponent * factor), std::nullopt,
                                        picture.bytes()});
            }
            const auto best = std::ranges::min_element(curve.points, {}, &Point::error);
            figure.note("{}: a factor of {} is best; {} remains, {} with the exponent unchanged", curve.name,
                        best->setting, numberText(best->error), numberText(curve.points.front().error));
            figure.curves.push_back(std::move(curve));
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
    const Shader reflection = highlightShader(bench, Highlight::reflection),
                 half = highlightShader(bench, Highlight::halfVector);
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

/// Signed distance from the torus around the z axis.
double torusDistance(const glm::dvec3& p) {
    return glm::length(glm::dvec2(glm::length(glm::dvec2(p)) - kRingRadius, p.z)) - kTubeRadius;
}

}  // namespace

glm::dmat3 torusRotation() {
    constexpr double kAngle = 50 * std::numbers::pi / 180;
    const double c = std::cos(kAngle), s = std::sin(kAngle);
    return {{1, 0, 0}, {0, c, -s}, {0, s, c}};
}

std::optional<glm::dvec3> normalAt(LitSurface surface, double x, double y) {
    if (surface == LitSurface::sphere) {
        const double zSquared = 1 - x * x - y * y;
        return zSquared < 0 ? std::nullopt : std::optional(glm::dvec3(x, y, std::sqrt(zSquared)));
    }
    // Sphere tracing: steps as long as the distance never pass through the surface (Hart 1996).
    constexpr double kHit = 1e-12, kReach = 1.5;
    constexpr int kMostSteps = 2000;
    const glm::dmat3 toModel = glm::transpose(torusRotation());
    const glm::dvec3 direction = toModel * glm::dvec3(0, 0, -1);
    glm::dvec3 p = toModel * glm::dvec3(x, y, kReach);
    double travelled = 0;
    for (int i = 0; i < kMostSteps && travelled < 2 * kReach; ++i) {
        const double step = torusDistance(p);
        if (step < kHit) {
            const glm::dvec2 ring = glm::normalize(glm::dvec2(p)) * kRingRadius;
            return glm::transpose(toModel) * glm::normalize(p - glm::dvec3(ring, 0));
        }
        p += direction * step;
        travelled += step;
    }
    return std::nullopt;
}

double highlight(Highlight model, const glm::dvec3& normal, const glm::dvec3& light, double exponent) {
    const glm::dvec3 viewer(0, 0, 1);
    const double facing = glm::dot(normal, light);
    if (facing <= 0) return 0;
    const double cosine = model == Highlight::reflection ? glm::dot(2 * facing * normal - light, viewer)
                                                         : glm::dot(normal, glm::normalize(light + viewer));
    return std::pow(std::max(cosine, 0.0), exponent);
}

double intensity(Highlight model, const glm::dvec3& normal, const glm::dvec3& light, double exponent) {
    return .1 + .5 * std::max(glm::dot(normal, light), 0.0) + .4 * highlight(model, normal, light, exponent);
}

std::vector<Figure> measureLighting(Bench& bench) {
    return {surfaceFigure(bench, LitSurface::sphere), surfaceFigure(bench, LitSurface::torus),
            halfVectorFigure(bench), modelFigure(bench)};
}

}  // namespace glibra::bench
