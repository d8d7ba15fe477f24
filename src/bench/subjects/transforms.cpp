#include <algorithm>
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
#include "bench/reference/exact.h"
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
std::vector<Four> cubePoints() {
    std::vector<Four> points;
    for (int i = 0; i < kPoints; ++i) {
        const glm::dvec3 place = glm::fract(glm::dvec3(.8191725134, .6710436067, .5497004779) * (i + .5));
        points.emplace_back(glm::vec3(2. * place - 1.), 1);
    }
    return points;
}

/// The largest error of the results, in sizes of the object.
std::function<double(const Numbers&)> placementError(const Placement& at, const std::vector<Four>& points) {
    const ExactMatrix model = exact(at.turnModel), view = exact(at.turnView);
    const ExactVector apart = exact(at.place) - exact(at.eye);
    std::vector<ExactVector> truth;
    for (const Four& p : points)
        truth.push_back(view * (model * (Exact(at.size) * exact(glm::dvec3(p))) + apart));
    return [truth = std::move(truth), size = at.size](const Numbers& results) {
        double largest = 0;
        for (std::size_t i = 0; i < truth.size(); ++i)
            largest = std::max(largest, distance(truth[i], glm::dvec3(results[i])) / size);
        return largest;
    };
}

/// Transforms all points on the CPU.
template <class Number>
void transform(const glm::mat<4, 4, Number>& matrix, const std::vector<Four>& points, Numbers& results) {
    for (std::size_t i = 0; i < points.size(); ++i)
        results[i] = glm::dvec4(matrix * glm::vec<4, Number>(points[i]));
}

std::vector<Computation> placementWays(Placement (*at)(double setting)) {
    using Case = ComputedCase;
    constexpr double kBytes = kPoints * (sizeof(glm::vec3) + sizeof(glm::dvec3));
    const auto model = [at](const Case& each) { return at(each.setting).model<double>(); };
    const auto view = [at](const Case& each) { return at(each.setting).view<double>(); };
    const auto onCpu = [](const char* name, const auto& matrix) {
        const auto work = [=](const Case& each, Numbers& results) {
            transform(matrix(each), each.inputs, results);
        };
        return Computation{name, work, kBytes, false};
    };
    return {
        onCpu("CPU, float matrices",
              [at](const Case& each) {
                  const Placement placement = at(each.setting);
                  return placement.view<float>() * placement.model<float>();
              }),
        onCpu("CPU, product in double, rounded once",
              [=](const Case& each) { return glm::mat4(view(each) * model(each)); }),
        onCpu("CPU, double", [=](const Case& each) { return view(each) * model(each); }),
        {.name = "shader, model then view",
         .glsl = R"(uniform mat4 uFirst, uSecond;
vec4 value() { return uSecond * (uFirst * vec4(given(0).xyz, 1.)); })",
         .uniforms =
             [=](const Shader& shader, const Case& each) {
                 shader.set("uFirst", glm::mat4(model(each))).set("uSecond", glm::mat4(view(each)));
             }},
        {.name = "shader, product in double, rounded once",
         .glsl = R"(uniform mat4 uFirst;
vec4 value() { return uFirst * vec4(given(0).xyz, 1.); })",
         .uniforms = [=](const Shader& shader,
                         const Case& each) { shader.set("uFirst", glm::mat4(view(each) * model(each))); }},
        // Mesa 25 takes dvec4(vec4(p)) for p, unless it is precise.
        {.name = "shader, double",
         .glsl = R"(uniform dmat4 uFirst, uSecond;
uniform int uHalf;
vec4 value() {
    dvec4 p = uSecond * (uFirst * dvec4(given(0).xyz, 1.));
    precise vec4 high = vec4(p);
    precise dvec4 rest = p - dvec4(high);
    return uHalf == 0 ? high : vec4(rest);
})",
         .uniforms = [=](const Shader& shader, const Case& each) {
             shader.setDouble("uFirst", model(each)).setDouble("uSecond", view(each));
         }}};
}

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
    const auto at = byDistance ? +[](double setting) { return Placement(setting, 1); }
                               : +[](double setting) { return Placement(1, setting); };
    const std::vector<Four> points = cubePoints();
    std::vector<ComputedCase> cases;
    for (int decade = byDistance ? 0 : -6; decade <= (byDistance ? 7 : 6); decade += bench.pick(3, 1)) {
        const double setting = std::pow(10., decade);
        cases.push_back({setting, fmt::format("{} 1e{}", byDistance ? "distance" : "size", decade),
                         placementError(at(setting), points), points});
    }
    addComputed(figure, bench, placementWays(at), cases);
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

/// The largest error of an entry of the matrix with these columns.
double entryError(const ExactMatrix& truth, const Numbers& columns) {
    Exact largest = 0;
    for (std::size_t column = 0; column < 3; ++column)
        for (std::size_t row = 0; row < 3; ++row)
            largest = std::max<Exact>(
                largest, abs(truth[column][row] - columns[column][static_cast<glm::length_t>(row)]));
    return static_cast<double>(largest);
}

/// The setting is the number of rotations; results are the columns of the matrix. `bytes` are those of the
/// state between two rotations.
///
/// `rotate` is called by a pointer: where GCC 12 knows the function, it leaves out roundings to float at -O3.
Computation chainWay(const char* name, glm::dmat3 (*rotate)(int), std::size_t bytes) {
    const auto columnsOf = [rotate](const ComputedCase& each, Numbers& columns) {
        const glm::dmat3 matrix = rotate(static_cast<int>(each.setting));
        for (glm::length_t i = 0; i < 3; ++i) columns[static_cast<std::size_t>(i)] = {matrix[i], 0};
    };
    return {name, columnsOf, static_cast<double>(bytes)};
}

std::vector<Computation> chainWays() {
    return {
        chainWay("float matrices multiplied", multipliedMatrices<float>, sizeof(glm::mat3)),
        chainWay("float, orthonormalised each time", orthonormalised, sizeof(glm::mat3)),
        chainWay("float quaternions", quaternions, sizeof(glm::quat)),
        chainWay("float, angle summed up", summedAngle, sizeof(float)),
        chainWay("float, angle = i * step", computedAngle<float>, sizeof(int)),
        chainWay("angle in double, matrix rounded once", roundedOnce, sizeof(int)),
        chainWay("double matrices multiplied", multipliedMatrices<double>, sizeof(glm::dmat3)),
        {.name = "shader, float matrices multiplied",
         .glsl = R"(uniform mat3 uStep;
uniform int uCount;
vec4 value() {
    mat3 m = mat3(1.);
    for (int i = 0; i < uCount; ++i) m = uStep * m;
    int column = int(given(0).x);
    return vec4(m[column], 0.);
})",
         .uniforms =
             [](const Shader& shader, const ComputedCase& each) {
                 shader.set("uStep", glm::mat3(rotation<double>(kTurn)))
                     .set("uCount", static_cast<int>(each.setting));
             }},
    };
}

Figure chainFigure(Bench& bench) {
    Figure figure{.name = "chain",
                  .title = "Chained rotations",
                  .settingName = "rotations",
                  .errorName = "largest error of an entry",
                  .reference =
                      "one rotation by the sum of the angles with 100 digits (Rodrigues' formula, "
                      "Boost.Multiprecision)",
                  .alternatives = Alternatives::setting};
    std::vector<ComputedCase> cases;
    for (const int count :
         bench.pick(std::vector{1, 100, 10000}, {1, 3, 10, 30, 100, 300, 1000, 3000, 10000}))
        cases.push_back(
            {1. * count,
             base::counted(count, "rotation"),
             [truth = exactRotation(count)](const Numbers& columns) { return entryError(truth, columns); },
             {Four(0), Four(1), Four(2)}});
    addComputed(figure, bench, chainWays(), cases);
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
std::vector<Four> normals() {
    std::vector<Four> all;
    for (int i = 0; i < kNormals; ++i) {
        const double z = 1 - (2 * i + 1.) / kNormals, around = 2 * std::numbers::pi * i * std::numbers::phi;
        const double across = std::sqrt(1 - z * z);
        all.emplace_back(across * std::cos(around), across * std::sin(around), z, 0);
    }
    return all;
}

/// The largest angle between results and normals, in degrees.
double largestAngle(const glm::dmat3& model, const std::vector<Four>& normals, const Numbers& results) {
    // Cofactors: the inverse transpose up to a factor, without a division.
    const ExactMatrix m = exact(model), matrix{cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
    double largest = 0;
    for (std::size_t i = 0; i < normals.size(); ++i)
        largest =
            std::max(largest, degreesBetween(matrix * exact(glm::dvec3(normals[i])), glm::dvec3(results[i])));
    return largest;
}

template <class Number>
glm::mat<3, 3, Number> cofactors(const glm::mat<3, 3, Number>& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

Computation normalWay(const char* name, glm::mat3 (*matrixFor)(const glm::dmat3& model)) {
    const auto transformed = [matrixFor](const ComputedCase& each, Numbers& results) {
        const glm::mat3 matrix = matrixFor(modelOf(each.setting));
        for (std::size_t i = 0; i < results.size(); ++i)
            results[i] = glm::dvec4(glm::normalize(matrix * glm::vec3(each.inputs[i])), 0);
    };
    return {name, transformed, 2. * kNormals * sizeof(glm::vec3) + sizeof(glm::mat3)};
}

std::vector<Computation> normalWays() {
    using glm::inverse, glm::transpose, glm::mat3, glm::dmat3;
    return {
        normalWay("the model matrix itself", [](const dmat3& m) { return mat3(m); }),
        normalWay("float inverse transpose", [](const dmat3& m) { return transpose(inverse(mat3(m))); }),
        normalWay("float cofactors", [](const dmat3& m) { return cofactors(mat3(m)); }),
        normalWay("double inverse transpose, rounded once",
                  [](const dmat3& m) { return mat3(transpose(inverse(m))); }),
        normalWay("double cofactors, rounded once", [](const dmat3& m) { return mat3(cofactors(m)); }),
        {.name = "shader, inverse transpose",
         .glsl = R"(uniform mat3 uModel;
vec4 value() { return vec4(normalize(transpose(inverse(uModel)) * given(0).xyz), 0.); })",
         .uniforms = [](const Shader& shader,
                        const ComputedCase& each) { shader.set("uModel", mat3(modelOf(each.setting))); }},
    };
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
    const std::vector<Four> all = normals();
    std::vector<ComputedCase> cases;
    for (const double ratio : bench.pick(std::vector{1., 30., 1000.}, {1., 3., 10., 30., 100., 300., 1000.}))
        cases.push_back(
            {ratio, fmt::format("1 : {:.0f}", ratio),
             [all, ratio](const Numbers& results) { return largestAngle(modelOf(ratio), all, results); },
             all});
    addComputed(figure, bench, normalWays(), cases);
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
