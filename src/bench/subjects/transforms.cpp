#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/ext/quaternion_double.hpp>
#include <glm/ext/quaternion_float.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "base/text.h"
#include "bench/core/device.h"
#include "bench/core/exact.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

// Points of an object seen by a nearby camera, both far from the origin or both small.

constexpr int kPoints = 1024;

/// eye space = turnView * (turnModel * (size * p) + place - eye); p is in a cube of side 2.
struct Placement {
    glm::dmat3 turnModel, turnView;
    glm::dvec3 place{0}, eye{0};
    double size = 1;

    Placement(double distance, double objectSize) : size(objectSize) {
        turnModel = glm::dmat3(glm::rotate(glm::dmat4(1), .7, glm::dvec3(.3, 1, .2)));
        turnView = glm::dmat3(glm::rotate(glm::dmat4(1), -1.1, glm::dvec3(1, .4, -.1)));
        place = distance * glm::dvec3(1, 1. / 3, -1. / 7);
        eye = place + objectSize * glm::dvec3(.5, 1.3, 5);
    }

    template <class Number>
    [[nodiscard]] glm::mat<4, 4, Number> model() const {
        using Vector = glm::vec<3, Number>;
        using Matrix = glm::mat<4, 4, Number>;
        return glm::scale(
            glm::translate(Matrix(1), Vector(place)) * Matrix(glm::mat<3, 3, Number>(turnModel)),
            Vector(static_cast<Number>(size)));
    }
    template <class Number>
    [[nodiscard]] glm::mat<4, 4, Number> view() const {
        return glm::translate(glm::mat<4, 4, Number>(glm::mat<3, 3, Number>(turnView)),
                              -glm::vec<3, Number>(eye));
    }
};

/// Low-discrepancy points (Roberts, The Unreasonable Effectiveness of Quasirandom Sequences, 2018).
std::vector<glm::vec3> cubePoints() {
    std::vector<glm::vec3> points;
    for (int i = 0; i < kPoints; ++i) {
        const glm::dvec3 place = glm::fract(glm::dvec3(.8191725134, .6710436067, .5497004779) * (i + .5));
        points.emplace_back(2. * place - 1.);
    }
    return points;
}

std::vector<ExactVector> exactResults(const Placement& placement, const std::vector<glm::vec3>& points) {
    const ExactMatrix model = exact(placement.turnModel), view = exact(placement.turnView);
    const ExactVector apart = exact(placement.place) - exact(placement.eye);
    std::vector<ExactVector> results;
    results.reserve(points.size());
    for (const glm::vec3& p : points)
        results.push_back(view * (model * (Exact(placement.size) * exact(glm::dvec3(p))) + apart));
    return results;
}

using Results = std::vector<glm::dvec3>;

double largestError(const std::vector<ExactVector>& truth, const Results& results, double size) {
    double largest = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        largest = std::max(largest, distance(truth[i], results[i]) / size);
    return largest;
}

struct PlacementMethod {
    const char* name;
    void (*transform)(const Placement&, const std::vector<glm::vec3>&, Results&);
};

template <class Number>
void transformPoints(const glm::mat<4, 4, Number>& matrix, const std::vector<glm::vec3>& points,
                     Results& results) {
    for (std::size_t i = 0; i < points.size(); ++i)
        results[i] = glm::dvec3(matrix * glm::vec<4, Number>(points[i], 1));
}

constexpr PlacementMethod kPlacementMethods[] = {
    {"CPU, float matrices",
     [](const Placement& placement, const std::vector<glm::vec3>& points, Results& results) {
         transformPoints(placement.view<float>() * placement.model<float>(), points, results);
     }},
    {"CPU, product in double, rounded once",
     [](const Placement& placement, const std::vector<glm::vec3>& points, Results& results) {
         transformPoints(glm::mat4(placement.view<double>() * placement.model<double>()), points, results);
     }},
    {"CPU, double",
     [](const Placement& placement, const std::vector<glm::vec3>& points, Results& results) {
         transformPoints(placement.view<double>() * placement.model<double>(), points, results);
     }},
};

struct PlacementShader {
    const char* name;
    const char* glsl;
    bool isDouble = false;
};

constexpr PlacementShader kPlacementShaders[] = {
    {"shader, model then view",
     "uniform mat4 uFirst, uSecond;\n"
     "vec4 value() { return uSecond * (uFirst * vec4(given(0).xyz, 1.)); }\n"},
    {"shader, product in double, rounded once",
     "uniform mat4 uFirst;\n"
     "vec4 value() { return uFirst * vec4(given(0).xyz, 1.); }\n"},
    {"shader, double",
     "uniform dmat4 uFirst, uSecond;\n"
     "uniform int uHalf;\n"
     "vec4 value() {\n"
     "    dvec4 p = uSecond * (uFirst * dvec4(given(0).xyz, 1.));\n"
     "    precise vec4 high = vec4(p);\n"  // Mesa 25 takes dvec4(vec4(p)) for p otherwise
     "    precise dvec4 rest = p - dvec4(high);\n"
     "    return uHalf == 0 ? high : vec4(rest);\n"
     "}\n",
     true},
};

void setMatrices(const PlacementShader& method, const Shader& shader, const Placement& placement) {
    const glm::dmat4 model = placement.model<double>(), view = placement.view<double>();
    if (method.isDouble)
        shader.setDouble("uFirst", model).setDouble("uSecond", view);
    else if (shader.has("uSecond"))
        shader.set("uFirst", glm::mat4(model)).set("uSecond", glm::mat4(view));
    else
        shader.set("uFirst", glm::mat4(view * model));
}

Results shaderResults(const PlacementShader& method, const ShaderValues& values) {
    Results results(kPoints, glm::dvec3(0));
    for (int half = 0; half < (method.isDouble ? 2 : 1); ++half) {
        values.shader().set("uHalf", half);
        const std::vector<Four> found = values.values();
        for (std::size_t i = 0; i < results.size(); ++i)
            results[i] += glm::dvec3(found[i][0], found[i][1], found[i][2]);
    }
    return results;
}

struct PlacementCase {
    double setting;
    std::string label;
    Placement placement;

    [[nodiscard]] Point point(const std::vector<glm::vec3>& points, const Results& results,
                              const Timing& time, double bytes) const {
        return {setting, label, largestError(exactResults(placement, points), results, placement.size), time,
                bytes};
    }
};

Figure placementFigure(Bench& bench, bool byDistance) {
    Figure figure{
        .name = byDistance ? "distance" : "size",
        .title =
            byDistance ? "Object and camera far from the origin" : "Objects of all sizes near the origin",
        .settingName = byDistance ? "distance from the origin in sizes of the object"
                                  : "size of an object at distance 1 from the origin",
        .errorName = "largest error in eye space",
        .errorUnit = "sizes",
        .reference =
            "the same positions with 100 digits (Boost.Multiprecision) from the same numbers; 1024 points",
        .alternatives = Alternatives::setting};
    std::vector<PlacementCase> cases;
    for (int decade = byDistance ? 0 : -6; decade <= (byDistance ? 7 : 6); decade += bench.pick(3, 1)) {
        const double setting = std::pow(10., decade);
        cases.push_back({setting, fmt::format("{} 1e{}", byDistance ? "distance" : "size", decade),
                         byDistance ? Placement(setting, 1) : Placement(1, setting)});
    }
    const std::vector<glm::vec3> points = cubePoints();
    for (const PlacementMethod& method : kPlacementMethods)
        for (const PlacementCase& each : cases) {
            Results results(points.size());
            const auto transform = [&] { method.transform(each.placement, points, results); };
            transform();
            figure.add(
                method.name,
                each.point(points, results, bench.time(transform),
                           static_cast<double>(points.size() * (sizeof(points[0]) + sizeof(results[0])))));
            figure.curves.back().isForScenes = false;
        }
    std::vector<Four> inputs;
    for (const glm::vec3& p : points) inputs.push_back({p.x, p.y, p.z, 1});
    for (const PlacementShader& method : kPlacementShaders)
        bench.attempt([&] {
            const ShaderValues values(bench, method.glsl, inputs);
            for (const PlacementCase& each : cases) {
                setMatrices(method, values.shader(), each.placement);
                const Results results = shaderResults(method, values);
                figure.add(method.name, each.point(points, results, bench.time([&] { values.compute(); }),
                                                   values.bytes()));
            }
        });
    for (const Curve& curve : figure.curves)
        figure.findings.push_back(byDistance ? orderSentence(curve, "distance", 10)
                                             : orderSentence(curve, "size", 0, .2));
    const auto farthest = [&](std::size_t curve) {
        return byDistance ? figure.last(curve) : figure.curves[curve].points.front();
    };
    figure.note(
        "at {}, float matrices are {} sizes off; the product made in double and rounded once, as for every "
        "scene, {} sizes: {:.2g} times better",
        farthest(0).label, numberText(farthest(0).error), numberText(farthest(1).error),
        farthest(0).error / farthest(1).error);
    return figure;
}

// A rotation by a bit more than one degree, applied again and again.

constexpr double kTurn = .0179;  ///< radians
const glm::dvec3 kAxis(1, 2, 3);

/// The rotation by `count` steps with 100 digits (Rodrigues' formula).
ExactMatrix exactRotation(int count) {
    const Exact angle = Exact(kTurn) * count, c = cos(angle), s = sin(angle);
    const ExactVector direction = exact(kAxis);
    const ExactVector k = (1 / length(direction)) * direction;
    ExactMatrix m;
    for (std::size_t column = 0; column < 3; ++column)
        for (std::size_t row = 0; row < 3; ++row) m[column][row] = (1 - c) * k[column] * k[row];
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
        m[i][i] += c;
        m[i][next] += s * k[last];
        m[i][last] -= s * k[next];
    }
    return m;
}

double largestEntryError(const ExactMatrix& truth, const glm::dmat3& matrix) {
    Exact largest = 0;
    for (std::size_t column = 0; column < 3; ++column)
        for (std::size_t row = 0; row < 3; ++row) {
            const double entry = matrix[static_cast<glm::length_t>(column)][static_cast<glm::length_t>(row)];
            largest = std::max<Exact>(largest, abs(truth[column][row] - entry));
        }
    return static_cast<double>(largest);
}

template <class Number>
glm::mat<3, 3, Number> rotation(Number angle) {
    return glm::mat<3, 3, Number>(glm::rotate(glm::mat<4, 4, Number>(1), angle, glm::vec<3, Number>(kAxis)));
}

template <class Number>
glm::dmat3 multipliedMatrices(int count) {
    const glm::mat<3, 3, Number> step = rotation<Number>(static_cast<Number>(kTurn));
    glm::mat<3, 3, Number> m(1);
    for (int i = 0; i < count; ++i) m = step * m;
    return glm::dmat3(m);
}

/// Gram-Schmidt orthogonalisation after every step.
glm::dmat3 orthonormalised(int count) {
    const glm::mat3 step = rotation<float>(static_cast<float>(kTurn));
    glm::mat3 m(1);
    for (int i = 0; i < count; ++i) {
        m = step * m;
        m[0] = glm::normalize(m[0]);
        m[1] = glm::normalize(m[1] - glm::dot(m[0], m[1]) * m[0]);
        m[2] = glm::cross(m[0], m[1]);
    }
    return glm::dmat3(m);
}

glm::dmat3 quaternions(int count) {
    const glm::quat step = glm::angleAxis(static_cast<float>(kTurn), glm::normalize(glm::vec3(kAxis)));
    glm::quat q(1, 0, 0, 0);
    for (int i = 0; i < count; ++i) q = glm::normalize(step * q);
    return glm::dmat3(glm::mat3_cast(q));
}

glm::dmat3 summedAngle(int count) {
    float angle = 0;
    for (int i = 0; i < count; ++i) angle += static_cast<float>(kTurn);
    return glm::dmat3(rotation<float>(angle));
}

template <class Number>
glm::dmat3 computedAngle(int count) {
    return glm::dmat3(rotation<Number>(static_cast<Number>(count) * static_cast<Number>(kTurn)));
}

/// In double, reduced to one turn, and rounded once.
glm::dmat3 roundedOnce(int count) {
    return glm::dmat3(glm::mat3(rotation<double>(count * kTurn)));
}

struct ChainMethod {
    const char* name;
    glm::dmat3 (*rotate)(int count);
    std::size_t bytes;  ///< of the state between two rotations
};

constexpr ChainMethod kChainMethods[] = {
    {"float matrices multiplied", multipliedMatrices<float>, sizeof(glm::mat3)},
    {"float, orthonormalised each time", orthonormalised, sizeof(glm::mat3)},
    {"float quaternions", quaternions, sizeof(glm::quat)},
    {"float, angle summed up", summedAngle, sizeof(float)},
    {"float, angle = i * step", computedAngle<float>, sizeof(int)},
    {"angle in double, matrix rounded once", roundedOnce, sizeof(int)},
    {"double matrices multiplied", multipliedMatrices<double>, sizeof(glm::dmat3)},
};

constexpr const char* kChainShader = R"(uniform mat3 uStep;
uniform int uCount;
vec4 value() {
    mat3 m = mat3(1.);
    for (int i = 0; i < uCount; ++i) m = uStep * m;
    int column = int(given(0).x);
    return vec4(m[column], 0.);
}
)";

Figure chainFigure(Bench& bench) {
    Figure figure{.name = "chain",
                  .title = "Chained rotations",
                  .settingName = "rotations",
                  .errorName = "largest error of an entry",
                  .reference =
                      "one rotation by the sum of the angles with 100 digits (Rodrigues' formula, "
                      "Boost.Multiprecision)",
                  .alternatives = Alternatives::setting};
    const std::vector<int> counts =
        bench.pick(std::vector{1, 100, 10000}, {1, 3, 10, 30, 100, 300, 1000, 3000, 10000});
    const auto add = [&](const char* curve, int count, const glm::dmat3& result, const Timing& time,
                         double bytes) {
        figure.add(curve, {1. * count, base::counted(count, "rotation"),
                           largestEntryError(exactRotation(count), result), time, bytes});
    };
    for (const ChainMethod& method : kChainMethods)
        for (const int count : counts) {
            const Timing time = bench.time([&] {
                // The result must reach memory, otherwise the compiler removes the work.
                const volatile double kept = method.rotate(count)[1][0];
                static_cast<void>(kept);
            });
            add(method.name, count, method.rotate(count), time, static_cast<double>(method.bytes));
        }
    bench.attempt([&] {
        const ShaderValues values(bench, kChainShader, std::array{Four{0}, Four{1}, Four{2}});
        values.shader().set("uStep", glm::mat3(rotation<double>(kTurn)));
        for (const int count : counts) {
            values.shader().set("uCount", count);
            const std::vector<Four> columns = values.values();
            glm::dmat3 matrix;
            for (int i = 0; i < 9; ++i)
                matrix[i / 3][i % 3] =
                    columns[static_cast<std::size_t>(i / 3)][static_cast<std::size_t>(i % 3)];
            add("shader, float matrices multiplied", count, matrix, bench.time([&] { values.compute(); }),
                values.bytes());
        }
    });
    figure.noteOrders("rotations", 10);
    figure.note("after {}: {} multiplied in float, {} from one angle in float, {} from one angle in double",
                figure.last(0).label, numberText(figure.last(0).error), numberText(figure.last(4).error),
                numberText(figure.last(5).error));
    return figure;
}

// Normals under scales that differ by axis.

constexpr int kNormals = 512;

/// Rotates an object, scales it by 1, sqrt(ratio) and ratio along its axes, and rotates it again.
glm::dmat3 modelOf(double ratio) {
    const glm::dmat3 first(glm::rotate(glm::dmat4(1), .6, glm::dvec3(1, -.3, .8))),
        second(glm::rotate(glm::dmat4(1), 2.1, glm::dvec3(.2, 1, .5)));
    glm::dmat3 scale(1);
    scale[1][1] = std::sqrt(ratio);
    scale[2][2] = ratio;
    return first * scale * second;
}

/// Normals spread over the sphere (Fibonacci lattice), as floats, as in a mesh.
std::vector<glm::vec3> normals() {
    std::vector<glm::vec3> all;
    for (int i = 0; i < kNormals; ++i) {
        const double z = 1 - (2 * i + 1.) / kNormals, around = 2 * std::numbers::pi * i * std::numbers::phi;
        const double across = std::sqrt(1 - z * z);
        all.emplace_back(across * std::cos(around), across * std::sin(around), z);
    }
    return all;
}

/// Cofactors: the inverse transpose up to a factor, without a division.
template <class Number>
glm::mat<3, 3, Number> cofactors(const glm::mat<3, 3, Number>& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

ExactMatrix exactCofactors(const ExactMatrix& m) {
    return {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
}

struct NormalMethod {
    const char* name;
    glm::mat3 (*matrix)(const glm::dmat3& model);
};

constexpr NormalMethod kNormalMethods[] = {
    {"the model matrix itself", [](const glm::dmat3& model) { return glm::mat3(model); }},
    {"float inverse transpose",
     [](const glm::dmat3& model) { return glm::transpose(glm::inverse(glm::mat3(model))); }},
    {"float cofactors", [](const glm::dmat3& model) { return cofactors(glm::mat3(model)); }},
    {"double inverse transpose, rounded once",
     [](const glm::dmat3& model) { return glm::mat3(glm::transpose(glm::inverse(model))); }},
    {"double cofactors, rounded once", [](const glm::dmat3& model) { return glm::mat3(cofactors(model)); }},
};

constexpr const char* kNormalShader = R"(uniform mat3 uModel;
vec4 value() { return vec4(normalize(transpose(inverse(uModel)) * given(0).xyz), 0.); }
)";

/// The largest angle between results and exact normals, which are in the order of normals().
double largestAngle(const glm::dmat3& model, const std::vector<glm::dvec3>& results) {
    const ExactMatrix matrix = exactCofactors(exact(model));
    const std::vector<glm::vec3> all = normals();
    double largest = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
        largest = std::max(largest, degreesBetween(matrix * exact(glm::dvec3(all[i])), results[i]));
    return largest;
}

Figure normalMatrixFigure(Bench& bench) {
    Figure figure{.name = "normal-matrix",
                  .title = "Normals of objects scaled unevenly",
                  .settingName = "largest scale over smallest",
                  .errorName = "largest angle",
                  .errorUnit = "degrees",
                  .reference =
                      "the cofactor matrix of the same double matrix with 100 digits "
                      "(Boost.Multiprecision); 512 normals",
                  .alternatives = Alternatives::setting};
    const std::vector<double> ratios =
        bench.pick(std::vector{1., 30., 1000.}, {1., 3., 10., 30., 100., 300., 1000.});
    const std::vector<glm::vec3> all = normals();
    std::vector<glm::vec3> transformed(all.size());
    const auto add = [&](const char* curve, double ratio, const std::vector<glm::dvec3>& results,
                         const Timing& time, double bytes) {
        figure.add(curve, {ratio, fmt::format("1 : {:.0f}", ratio), largestAngle(modelOf(ratio), results),
                           time, bytes});
    };
    for (const NormalMethod& method : kNormalMethods)
        for (const double ratio : ratios) {
            const glm::dmat3 model = modelOf(ratio);
            const Timing time = bench.time([&] {
                const glm::mat3 matrix = method.matrix(model);
                for (std::size_t i = 0; i < all.size(); ++i) transformed[i] = glm::normalize(matrix * all[i]);
            });
            add(method.name, ratio, {transformed.begin(), transformed.end()}, time,
                static_cast<double>(2 * all.size() * sizeof(all[0]) + sizeof(glm::mat3)));
        }
    bench.attempt([&] {
        std::vector<Four> inputs;
        for (const glm::vec3& each : all) inputs.push_back({each.x, each.y, each.z, 0});
        const ShaderValues values(bench, kNormalShader, inputs);
        for (const double ratio : ratios) {
            values.shader().set("uModel", glm::mat3(modelOf(ratio)));
            std::vector<glm::dvec3> results;
            for (const Four& each : values.values()) results.emplace_back(each[0], each[1], each[2]);
            add("shader, inverse transpose", ratio, results, bench.time([&] { values.compute(); }),
                values.bytes());
        }
    });
    figure.noteOrders("ratio", 10, 1);
    figure.note(
        "at {}: the model matrix itself is {} degrees off, the inverse transpose in float {}, in double and "
        "rounded once {}",
        figure.last(0).label, numberText(figure.last(0).error), numberText(figure.last(1).error),
        numberText(figure.last(3).error));
    return figure;
}

}  // namespace

std::vector<Figure> measureTransforms(Bench& bench) {
    return {placementFigure(bench, true), placementFigure(bench, false), chainFigure(bench),
            normalMatrixFigure(bench)};
}

}  // namespace glibra::bench
