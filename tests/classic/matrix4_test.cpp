// Matrix4, Vec3 and Point3: the book's examples, and what it leaves open (docs/classic.md).

#include <glibra/classic/matrix4.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace glibra::classic {
namespace {

void expectNear(const Matrix4& a, const Matrix4& b, double tolerance = 1e-5) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            EXPECT_NEAR(static_cast<double>(a.GetElement(i, j)), static_cast<double>(b.GetElement(i, j)),
                        tolerance)
                << "row " << i << ", column " << j;
}
void expectNear(const Vec3& a, const Vec3& b) {
    EXPECT_NEAR(static_cast<double>((a - b).Length()), 0, 1e-5)
        << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " " << b.z;
}

TEST(Vec3, AreaOfATriangle) {
    const Point3 q(0, 0, 0);
    const Point3 r(2, 0, 0);
    const Point3 s(0, 3, 0);
    EXPECT_FLOAT_EQ((r - q).Cross(s - q).Length() / 2, 3);
    expectNear((r - q).Cross(s - q), {0, 0, 6});
    EXPECT_FLOAT_EQ((r - q).Dot(s - q), 0);
}

TEST(Vec3, UnitLeavesTheVectorAndUnitizeDoesNot) {
    Vec3 v(3, 0, 4);
    expectNear(v.Unit(), {.6F, 0, .8F});
    expectNear(v, {3, 0, 4});
    EXPECT_FLOAT_EQ(v.Unitize().Length(), 1);
    expectNear(v, {.6F, 0, .8F});
    Vec3 zero;
    expectNear(zero.Unitize(), {0, 0, 0});
}

TEST(Matrix4, PointsAreMovedAndDirectionsAreNot) {
    Matrix4 m;
    m.Translatef(1, 2, 3);
    expectNear(m * Point3(1, 1, 1), Point3(2, 3, 4));
    expectNear(m * Vec3(1, 1, 1), Vec3(1, 1, 1));
    expectNear(m.MultBy(Point3(1, 1, 1)), Point3(2, 3, 4));
    EXPECT_FLOAT_EQ(m.GetElement(0, 3), 1);
    EXPECT_FLOAT_EQ(m.GetElement(2, 3), 3);
}

TEST(Matrix4, TransformsTakeEffectInTheOrderOfTheCalls) {
    // The book's example: a scale about a point leaves the point where it is.
    Matrix4 m;
    m.Translatef(-1, -2, -3).Scalef(2, 2, 2).Translatef(1, 2, 3);
    expectNear(m * Point3(1, 2, 3), Point3(1, 2, 3));
    expectNear(m * Point3(2, 2, 3), Point3(3, 2, 3));
}

TEST(Matrix4, OpenGLOrderIsThatOfTheMatrixStack) {
    Matrix4 old;
    old.OpenGLOrder();
    old.Translatef(1, 2, 3).Scalef(2, 2, 2).Translatef(-1, -2, -3);
    Matrix4 m;
    m.Translatef(-1, -2, -3).Scalef(2, 2, 2).Translatef(1, 2, 3);
    expectNear(old, m);
    old.OpenGLOrder(false).LoadIdentity().Rotatef(90, 0, 0, 1).Translatef(1, 0, 0);
    expectNear(old * Point3(1, 0, 0), Point3(1, 1, 0));
}

TEST(Matrix4, RotationTimesTranslationIsNotTranslationTimesRotation) {
    Matrix4 r;
    Matrix4 t;
    r.Rotatef(90, 0, 0, 1);
    t.Translatef(1, 0, 0);
    expectNear(r * t * Point3(0, 0, 0), Point3(0, 1, 0));
    expectNear(t * r * Point3(0, 0, 0), Point3(1, 0, 0));
}

/// EX1.2: the inverses of all transforms, as formulas and as numbers.
TEST(Matrix4, InversesAreThoseOfTheFormulas) {
    struct Case {
        std::string name;
        std::function<void(Matrix4&)> make, inverse;
        double determinant;
    };
    const std::vector<Case> cases{
        {"rotate", [](Matrix4& m) { m.Rotatef(37, 1, 2, 3); }, [](Matrix4& m) { m.Rotatef(-37, 1, 2, 3); },
         1},
        {"scale", [](Matrix4& m) { m.Scalef(2, 4, .5F); }, [](Matrix4& m) { m.Scalef(.5F, .25F, 2); }, 4},
        {"translate", [](Matrix4& m) { m.Translatef(1, -2, 3); }, [](Matrix4& m) { m.Translatef(-1, 2, -3); },
         1},
        {"all", [](Matrix4& m) { m.Rotatef(20, 0, 1, 0).Scalef(1, 2, 3).Translatef(4, 5, 6); },
         [](Matrix4& m) { m.Translatef(-4, -5, -6).Scalef(1, .5F, 1 / 3.F).Rotatef(-20, 0, 1, 0); }, 6}};
    for (const Case& each : cases) {
        SCOPED_TRACE(each.name);
        Matrix4 m;
        Matrix4 formula;
        each.make(m);
        each.inverse(formula);
        expectNear(m.GetInverse(), formula);
        expectNear(m.GetInverse() * m, Matrix4());
        expectNear(Matrix4(m).Invert().Invert(), m);
        EXPECT_NEAR(static_cast<double>(m.GetDeterminant()), each.determinant, 1e-5);
        EXPECT_NEAR(static_cast<double>(m.GetInverse().GetDeterminant()), 1 / each.determinant, 1e-5);
        const Matrix4 normals = m.GetInverse3();
        expectNear(normals.GetTranspose3(), formula.GetTranspose3());
        EXPECT_EQ(normals.GetElement(0, 3), 0);
    }
}

TEST(Matrix4, WithoutAnInverseStaysAsItIsAndSaysSo) {
    Matrix4 m;
    m.Scalef(1, 0, 1);
    testing::internal::CaptureStderr();
    expectNear(m.GetInverse(), m);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("no inverse"), std::string::npos);
}

TEST(Matrix4, ProjectionsAreThoseOfOldOpenGL) {
    Matrix4 perspective;
    perspective.Perspective(90, 2, 1, 10);
    expectNear(perspective, Matrix4(.5F, 0, 0, 0, 0, 1, 0, 0, 0, 0, -11 / 9.F, -20 / 9.F, 0, 0, -1, 0));
    Matrix4 frustum;
    frustum.Frustum(-2, 2, -1, 1, 1, 10);
    expectNear(frustum, perspective);
    Matrix4 far;
    far.FrustumZ(-6, 6, -3, 3, 1, 10, 3);
    expectNear(far, perspective);
    Matrix4 ortho;
    ortho.Ortho(-2, 2, -1, 1, 1, 10);
    expectNear(ortho * Point3(2, 1, -10), Point3(1, 1, 1));
    Matrix4 flat;
    flat.Ortho2D(0, 4, 0, 2);
    expectNear(flat * Point3(4, 0, 1), Point3(1, -1, -1));
    Matrix4 view;
    view.LookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);
    expectNear(view * Point3(0, 0, 0), Point3(0, 0, -5));
}

TEST(Matrix4, BothEyesSeeTheSameAtTheDistanceOfTheWindow) {
    Matrix4 left;
    Matrix4 right;
    left.StereoPerspective(60, 1.5F, 1, 100, 8, -.2F);
    right.StereoPerspective(60, 1.5F, 1, 100, 8, .2F);
    const Point3 at(1, 2, -8);
    const Point3 nearer(1, 2, -4);
    expectNear(left * at, right * at);
    EXPECT_GT((left * nearer).x, (right * nearer).x);
    Matrix4 middle;
    Matrix4 mono;
    middle.StereoPerspective(60, 1.5F, 1, 100, 8, 0);
    expectNear(middle, mono.Perspective(60, 1.5F, 1, 100));
}

TEST(Matrix4, ArraysHoldRows) {
    float m[4][4];
    Matrix4().Translatef(5, 6, 7).GetMatrix4(m);
    EXPECT_EQ(m[0][3], 5);
    EXPECT_EQ(m[2][3], 7);
    expectNear(Matrix4(m), Matrix4().Translatef(5, 6, 7));
    float small[3][3];
    Matrix4().Scalef(1, 2, 3).GetMatrix43(small);
    EXPECT_EQ(small[1][1], 2);
    Matrix4 back;
    EXPECT_EQ(back.SetMatrix43(small).GetElement(2, 2), 3);
    EXPECT_EQ(back.GetElement(3, 3), 1);
    EXPECT_EQ(back.SetElement(0, 1, 9).GetTranspose().GetElement(1, 0), 9);
}

TEST(Matrix4, OperatorsAreThoseOfElements) {
    Matrix4 m;
    expectNear(m + m, m * 2.F);
    expectNear(2.F * m - m, m);
    expectNear(-m, m * -1.F);
    EXPECT_EQ((m + 1.F).GetElement(0, 1), 1);
    EXPECT_EQ((m - 1.F).GetElement(0, 0), 0);
    m *= Matrix4().Scalef(3, 3, 3);
    EXPECT_EQ(m.GetElement(0, 0), 3);
}

TEST(Matrix4, HasAStackOfItsOwn) {
    Matrix4 m;
    Matrix4 other;
    m.Translatef(1, 0, 0).PushMatrix4().Scalef(2, 2, 2);
    Matrix4 copy = m;
    expectNear(m.PopMatrix4(), Matrix4().Translatef(1, 0, 0));
    expectNear(copy.PopMatrix4(), m);
    testing::internal::CaptureStderr();
    expectNear(other.PopMatrix4(), Matrix4());
    EXPECT_NE(testing::internal::GetCapturedStderr().find("PopMatrix4"), std::string::npos);
}

}  // namespace
}  // namespace glibra::classic
