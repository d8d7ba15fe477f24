#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "bench/core/device.h"
#include "bench/reference/exact.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

constexpr int kRays = 2048;
constexpr double kMissed = std::numeric_limits<double>::quiet_NaN();

/// Origin and direction toward a sphere of radius 1 around the origin. The direction has unit length up to
/// rounding; no formula here relies on it.
struct Ray {
    glm::vec3 origin{0}, direction{0};
};

/// The exact distance along the ray to the nearer intersection; empty if the ray misses.
struct Truth {
    bool hits = false;
    Exact distance = 0;
};

/// Rays from all around at `distance`, toward points of a disc of radius `largest` > 0 through the centre of
/// the sphere, perpendicular to the rays: evenly spread from `smallest`.
std::vector<Ray> raysFrom(double distance, double smallest, double largest) {
    std::vector<Ray> rays;
    for (int i = 0; i < kRays; ++i) {
        const double place = (i + .5) / kRays, turn = 2 * std::numbers::pi * std::numbers::phi * i;
        const double z = 1 - 2 * place, around = std::sqrt(1 - z * z);
        const glm::dvec3 out(around * std::cos(turn), around * std::sin(turn), z);
        const glm::dvec3 right = glm::normalize(glm::cross(out, glm::dvec3(.31, .52, -.8)));
        const glm::dvec3 up = glm::cross(out, right);
        const double mixed = std::fmod(i * .7548776662 + .5, 1.),
                     angle = 2 * std::numbers::pi * .5698402910 * i;
        const double radius = std::sqrt(std::lerp(smallest * smallest, largest * largest, mixed));
        const glm::dvec3 target = radius * (std::cos(angle) * right + std::sin(angle) * up);
        Ray ray;
        ray.origin = glm::vec3(distance * out);
        ray.direction = glm::vec3(glm::normalize(target - glm::dvec3(ray.origin)));
        rays.push_back(ray);
    }
    return rays;
}

Truth truthOf(const Ray& ray) {
    const ExactVector o = exact(glm::dvec3(ray.origin)), d = exact(glm::dvec3(ray.direction));
    const Exact a = dot(d, d), b = dot(o, d), c = dot(o, o) - 1, discriminant = b * b - a * c;
    if (discriminant < 0) return {};
    return {true, (-b - sqrt(discriminant)) / a};
}

/// a t^2 + b t + c = 0 solved as in textbooks.
template <class Number>
double textbook(const Ray& ray) {
    const glm::vec<3, Number> o(ray.origin), d(ray.direction);
    const Number a = glm::dot(d, d), b = 2 * glm::dot(o, d), c = glm::dot(o, o) - 1;
    const Number discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return kMissed;
    return static_cast<double>((-b - std::sqrt(discriminant)) / (2 * a));
}

/// The discriminant from the distance of the centre from the ray (Hearn and Baker, Computer Graphics with
/// OpenGL), and the root without cancellation (Haines, Günther, Akenine-Möller, Precision Improvements for
/// Ray/Sphere Intersection, Ray Tracing Gems, chapter 7, 2019).
template <class Number>
double stable(const Ray& ray) {
    const glm::vec<3, Number> o(ray.origin), d(ray.direction);
    const Number a = glm::dot(d, d), b = -glm::dot(o, d);
    const glm::vec<3, Number> across = o + (b / a) * d;
    const Number discriminant = 1 - glm::dot(across, across);
    if (discriminant < 0) return kMissed;
    const Number c = glm::dot(o, o) - 1, q = b + std::copysign(std::sqrt(a * discriminant), b);
    return static_cast<double>(c / q);
}

/// The same discriminant with the textbook root.
double stableDiscriminant(const Ray& ray) {
    const float a = glm::dot(ray.direction, ray.direction), b = -glm::dot(ray.origin, ray.direction);
    const glm::vec3 across = ray.origin + (b / a) * ray.direction;
    const float discriminant = 1 - glm::dot(across, across);
    return discriminant < 0 ? kMissed : static_cast<double>((b - std::sqrt(a * discriminant)) / a);
}

/// The result for the rays of one distance: where each hits, and 1 for those that do.
struct Outcome {
    double distance = 0;  ///< largest error of the hit along the ray, over rays that rightly hit
    double wrong = 0;     ///< share of rays that hit where they should miss, or the reverse
};

Outcome judge(const std::vector<Truth>& truths, const Numbers& hits) {
    Outcome outcome;
    for (std::size_t i = 0; i < truths.size(); ++i) {
        const bool isHit = hits[i].y > .5;
        if (isHit != truths[i].hits)
            outcome.wrong += 1. / kRays;
        else if (isHit)
            outcome.distance = std::max(outcome.distance,
                                        std::abs(static_cast<double>(Exact(hits[i].x) - truths[i].distance)));
    }
    return outcome;
}

template <double (*hit)(const Ray&)>
void hitAll(const ComputedCase& each, Numbers& hits) {
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const double distance = hit({each.inputs[2 * i], each.inputs[2 * i + 1]});
        hits[i] = {distance, std::isnan(distance) ? 0 : 1, 0, 0};
    }
}

constexpr double kRayBytes = kRays * (sizeof(Ray) + sizeof(double));

const std::vector<Computation> kRayWays{
    {"CPU, float, textbook", hitAll<textbook<float>>, kRayBytes, false},
    {"CPU, float, discriminant by distance", hitAll<stableDiscriminant>, kRayBytes, false},
    {"CPU, float, stable", hitAll<stable<float>>, kRayBytes, false},
    {"CPU, double, textbook", hitAll<textbook<double>>, kRayBytes, false},
    {"CPU, double, stable", hitAll<stable<double>>, kRayBytes, false},
    {.name = "shader, textbook", .glsl = R"(vec4 value() {
    vec3 o = given(0).xyz, d = given(1).xyz;
    float a = dot(d, d), b = 2. * dot(o, d), c = dot(o, o) - 1., discriminant = b * b - 4. * a * c;
    return discriminant < 0. ? vec4(0.) : vec4((-b - sqrt(discriminant)) / (2. * a), 1., 0., 0.);
})"},
    {.name = "shader, stable", .glsl = R"(vec4 value() {
    vec3 o = given(0).xyz, d = given(1).xyz;
    float a = dot(d, d), b = -dot(o, d);
    vec3 across = o + (b / a) * d;
    float discriminant = 1. - dot(across, across);
    if (discriminant < 0.) return vec4(0.);
    float root = sqrt(a * discriminant), q = b < 0. ? b - root : b + root;
    return vec4((dot(o, o) - 1.) / q, 1., 0., 0.);
})"},
};

/// Adds a curve for each way to the figure, by the distance of rays that pass the centre between the two
/// radii.
void addCurves(Figure& figure, Bench& bench, double smallest, double largest, double Outcome::* error) {
    figure.settingName = "distance of the ray's origin in radii";
    figure.alternatives = Alternatives::setting;
    std::vector<ComputedCase> cases;
    for (int decade = 0; decade <= 6; decade += bench.pick(3, 1)) {
        const double distance = decade == 0 ? 1.5 : std::pow(10., decade);
        std::vector<Four> inputs;
        std::vector<Truth> truths;
        for (const Ray& ray : raysFrom(distance, smallest, largest)) {
            inputs.insert(inputs.end(), {Four(ray.origin, 0), Four(ray.direction, 0)});
            truths.push_back(truthOf(ray));
        }
        cases.push_back(
            {distance, fmt::format("distance {:.6g}", distance),
             [truths = std::move(truths), error](const Numbers& hits) { return judge(truths, hits).*error; },
             std::move(inputs)});
    }
    addComputed(figure, bench, kRayWays, cases, 2);
}

Figure hitFigure(Bench& bench) {
    Figure figure{.name = "hit",
                  .title = "Where the ray meets the sphere, by distance",
                  .errorName = "largest error along the ray",
                  .errorUnit = "radii",
                  .reference =
                      "the exact root for the same floats, with 100 digits (Boost.Multiprecision); 2048 "
                      "rays through the inner .9 of the sphere"};
    addCurves(figure, bench, 0, .9, &Outcome::distance);
    figure.noteOrders("distance", 10);
    figure.note("at {}: textbook {} radii, stable {} radii, both in float", figure.last(0).label,
                numberText(figure.last(0).error), numberText(figure.last(2).error));
    return figure;
}

Figure decisionFigure(Bench& bench) {
    Figure figure{.name = "decision",
                  .title = "Rays near the outline that hit or miss wrongly",
                  .errorName = "share of wrong rays",
                  .reference =
                      "the sign of the exact discriminant with 100 digits; 2048 rays that pass the "
                      "centre at .99 to 1.01 radii",
                  .countsWrong = true};
    addCurves(figure, bench, .99, 1.01, &Outcome::wrong);
    for (const std::size_t i : {0U, 2U}) {
        const Curve& curve = figure.curves[i];
        const auto first =
            std::ranges::find_if(curve.points, [](const Point& each) { return each.error > 0; });
        if (first == curve.points.end())
            figure.note("{}: no ray is wrong up to {}", curve.name, curve.points.back().label);
        else
            figure.note("{}: the first wrong rays at {}", curve.name, first->label);
    }
    figure.note(
        "at {}: {:.1f} % of the rays are wrong with the textbook formula, {:.1f} % with the stable one",
        figure.last(0).label, 100 * figure.last(0).error, 100 * figure.last(2).error);
    return figure;
}

}  // namespace

std::vector<Figure> measureRaySphere(Bench& bench) {
    return {hitFigure(bench), decisionFigure(bench)};
}

}  // namespace glibra::bench
