// The matrices of cameras as a shader gets them, against closed forms in extended precision: views, inverse
// views, reflected cameras with an oblique near plane, shifted eyes, off-axis frusta, boxes, shadow matrices.

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "modern_text.h"

namespace glibra::test {
namespace {

using Real = long double;
using Vector = std::array<Real, 3>;
using Matrix4 = std::array<std::array<Real, 4>, 4>;  ///< columns

Real dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unit(const Vector& a) {
    const Real length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}
Matrix4 product(const Matrix4& a, const Matrix4& b) {
    Matrix4 made{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t k = 0; k < 4; ++k) made[column][row] += a[k][row] * b[column][k];
    return made;
}

/// Axes and place of an eye.
struct Eye {
    Vector right, up, back, place;

    static Eye lookingAt(const Vector& eye, const Vector& centre, const Vector& up) {
        const Vector back = unit({eye[0] - centre[0], eye[1] - centre[1], eye[2] - centre[2]});
        const Vector right = unit(cross(up, back));
        return {right, cross(back, right), back, eye};
    }
    /// The mirror image about n . x + d = 0.
    [[nodiscard]] Eye mirrored(const Vector& n, Real d) const {
        const auto turned = [&](const Vector& v, Real offset) {
            const Real scale = 2 * (dot(n, v) + offset) / dot(n, n);
            return Vector{v[0] - scale * n[0], v[1] - scale * n[1], v[2] - scale * n[2]};
        };
        return {turned(right, 0), turned(up, 0), turned(back, 0), turned(place, d)};
    }
    [[nodiscard]] Eye shifted(const Vector& by) const {
        Eye made = *this;
        for (std::size_t i = 0; i < 3; ++i)
            made.place[i] += by[0] * right[i] + by[1] * up[i] + by[2] * back[i];
        return made;
    }
    [[nodiscard]] Matrix4 inverseView() const {
        Matrix4 made{};
        for (std::size_t i = 0; i < 3; ++i) {
            made[0][i] = right[i];
            made[1][i] = up[i];
            made[2][i] = back[i];
            made[3][i] = place[i];
        }
        made[3][3] = 1;
        return made;
    }
    [[nodiscard]] Matrix4 view() const {
        Matrix4 made{};
        const std::array<const Vector*, 3> rows{&right, &up, &back};
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < 3; ++column) made[column][row] = (*rows[row])[column];
            made[3][row] = -dot(*rows[row], place);
        }
        made[3][3] = 1;
        return made;
    }
};

Matrix4 frustum(Real l, Real r, Real b, Real t, Real n, Real f) {
    Matrix4 made{};
    made[0][0] = 2 * n / (r - l);
    made[1][1] = 2 * n / (t - b);
    made[2] = {(r + l) / (r - l), (t + b) / (t - b), -(f + n) / (f - n), -1};
    made[3][2] = -2 * f * n / (f - n);
    return made;
}
Matrix4 perspective(Real degrees, Real aspect, Real n, Real f) {
    const Real top = n * std::tan(degrees * 3.14159265358979323846264338327950288L / 360);
    return frustum(-top * aspect, top * aspect, -top, top, n, f);
}
Matrix4 box(Real l, Real r, Real b, Real t, Real n, Real f) {
    Matrix4 made{};
    made[0][0] = 2 / (r - l);
    made[1][1] = 2 / (t - b);
    made[2][2] = -2 / (f - n);
    made[3] = {-(r + l) / (r - l), -(t + b) / (t - b), -(f + n) / (f - n), 1};
    return made;
}
/// Clip coordinates to 0..1.
Matrix4 shadow(const Matrix4& clip) {
    Matrix4 bias{};
    for (std::size_t i = 0; i < 3; ++i) bias[i][i] = bias[3][i] = .5L;
    bias[3][3] = 1;
    return product(bias, clip);
}
/// A symmetrical perspective whose near plane is n . x + d = 0 of the world, seen by `eye`; the eye's own
/// side is clipped. E. Lengyel, Oblique View Frustum Depth Projection and Clipping, 2005.
Matrix4 oblique(const Matrix4& projection, const Eye& eye, const Vector& n, Real d) {
    const Real length = std::sqrt(dot(n, n));
    std::array<Real, 4> plane{dot(n, eye.right) / length, dot(n, eye.up) / length, dot(n, eye.back) / length,
                              (dot(n, eye.place) + d) / length};
    if (plane[3] > 0)
        for (Real& each : plane) each = -each;
    const std::array<Real, 4> corner{(plane[0] < 0 ? -1 : 1) / projection[0][0],
                                     (plane[1] < 0 ? -1 : 1) / projection[1][1], -1,
                                     (1 + projection[2][2]) / projection[3][2]};
    Real scale = 0;
    for (std::size_t i = 0; i < 4; ++i) scale += plane[i] * corner[i];
    Matrix4 made = projection;
    for (std::size_t i = 0; i < 4; ++i) made[i][2] = 2 * plane[i] / scale - projection[i][3];
    return made;
}

/// Writes scenes: each number as it stands in the text and as it is read.
class Writer {
  public:
    Real number(double least, double most) {
        const double value = std::uniform_real_distribution<>(least, most)(random_);
        char digits[32];
        std::snprintf(digits, sizeof digits, "%.4f", value);
        text += " " + std::string(digits);
        return std::strtod(digits, nullptr);  // what the scene states is a double
    }
    Vector vector(double least, double most) {
        const Real x = number(least, most), y = number(least, most), z = number(least, most);
        return {x, y, z};
    }
    std::string text;

  private:
    std::mt19937 random_{14};
};

constexpr int kCameras = 24;

struct Expected {
    std::string what;
    Matrix4 matrix;
};

TEST(ModernMatrices, ReachShadersToOneUnitInTheLastPlace) {
    if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    Writer writer;
    std::vector<Expected> expected;
    std::string dispatches;
    const auto want = [&](const std::string& expression, const Matrix4& matrix) {
        dispatches += "Set uMatrix (" + expression + ") uIndex (" + std::to_string(expected.size()) +
                      ")\nDispatch Copy 1 1 1\n";
        expected.push_back({expression, matrix});
    };
    for (int i = 0; i < kCameras; ++i) {
        const std::string n = std::to_string(i);
        const auto eye = [&](const std::string& name) {
            writer.text += "\nCamera " + name + " LookAt";
            const Vector place = writer.vector(2, 50), centre = writer.vector(-3, 1);
            writer.text += " 0.1 1 0.2";
            return Eye::lookingAt(place, centre, {.1, 1, .2});
        };
        const Eye sun = eye("sun" + n);
        writer.text += " Perspective";
        const Real angle = writer.number(10, 120), near = writer.number(.05, 2), far = writer.number(20, 500);
        writer.text += " aspect";
        const Matrix4 lens = perspective(angle, writer.number(.5, 2), near, far);
        want("sun" + n + ".view", sun.view());
        want("sun" + n + ".inverseView", sun.inverseView());
        want("sun" + n + ".projection", lens);
        want("sun" + n + ".viewProjection", product(lens, sun.view()));
        want("sun" + n + ".shadow", shadow(product(lens, sun.view())));

        writer.text += "\nCamera mirror" + n + " Reflect sun" + n;
        const Vector normal = writer.vector(.2, 3);
        const Real offset = writer.number(-1, 4);
        writer.text += " clip";
        const Eye mirror = sun.mirrored(normal, offset);
        want("mirror" + n + ".view", mirror.view());
        want("mirror" + n + ".inverseView", mirror.inverseView());
        want("mirror" + n + ".projection", oblique(lens, mirror, normal, offset));

        writer.text += "\nCamera side" + n + " Shift sun" + n;
        const Eye side = sun.shifted(writer.vector(-2, 2));
        want("side" + n + ".view", side.view());
        want("side" + n + ".inverseView", side.inverseView());

        const Eye cave = eye("cave" + n);
        writer.text += " Frustum";
        const Real l = writer.number(-3, -.1), r = writer.number(.2, 4), b = writer.number(-2, -.3),
                   t = writer.number(.1, 1), fn = writer.number(.1, 3), ff = writer.number(10, 90);
        want("cave" + n + ".projection", frustum(l, r, b, t, fn, ff));
        want("cave" + n + ".viewProjection", product(frustum(l, r, b, t, fn, ff), cave.view()));

        const Eye plan = eye("plan" + n);
        writer.text += " Ortho";
        const Real bl = writer.number(-9, -1), br = writer.number(1, 8), bb = writer.number(-7, -1),
                   bt = writer.number(1, 6), bn = writer.number(-5, 1), bf = writer.number(10, 90);
        want("plan" + n + ".projection", box(bl, br, bb, bt, bn, bf));
        want("plan" + n + ".shadow", shadow(product(box(bl, br, bb, bt, bn, bf), plan.view())));

        // The matrix that a caster's vertices take to the map: bias, projection, view and model.
        dispatches += "Group\nTranslate 1.5 -2.25 .75\nScale 2 .5 4\n";
        Matrix4 model{};
        model[0][0] = 2;
        model[1][1] = .5L;
        model[2][2] = 4;
        model[3] = {1.5L, -2.25L, .75L, 1};
        want("sun" + n + ".shadow * model", product(shadow(product(lens, sun.view())), model));
        dispatches += "EndGroup\n";
    }
    RenderOptions everything;
    everything.skip = false;
    TextScene scene(
        "WindowSize 4 4" + writer.text + "\nBuffer Found float " + std::to_string(expected.size() * 16) + R"(
Compute inline
#version 430 core
layout(local_size_x = 1) in;
uniform mat4 uMatrix;
uniform int uIndex;
layout(std430) writeonly buffer Found { float found[]; };
void main() {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) found[uIndex * 16 + c * 4 + r] = uMatrix[c][r];
}
EndCompute
Program Copy
)" + dispatches,
        {}, everything);
    scene.draw();
    const std::vector<double> found = scene.buffer("Found", expected.size() * 16);
    double worst = 0;
    for (std::size_t k = 0; k < expected.size(); ++k) {
        Real largest = 0;
        for (const auto& column : expected[k].matrix)
            for (const Real each : column) largest = std::max(largest, std::abs(each));
        for (std::size_t i = 0; i < 16; ++i) {
            const Real exact = expected[k].matrix[i / 4][i % 4];
            const auto magnitude = static_cast<float>(std::abs(exact));
            const Real unitInLastPlace = std::nextafter(magnitude, INFINITY) - magnitude;
            const Real error = std::abs(exact - found[k * 16 + i]);
            // Where terms cancel, doubles round relative to the terms, not to the sum.
            EXPECT_LE(error, std::max(unitInLastPlace, largest * 0x1p-50L))
                << expected[k].what << "[" << i / 4 << "][" << i % 4 << "] is " << found[k * 16 + i]
                << ", exactly " << static_cast<double>(exact);
            if (unitInLastPlace > largest * 0x1p-50L)
                worst = std::max(worst, static_cast<double>(error / unitInLastPlace));
        }
    }
    EXPECT_LE(worst, .5001) << "units in the last place: rounded once";
    EXPECT_GT(worst, .45);
}

}  // namespace
}  // namespace glibra::test
