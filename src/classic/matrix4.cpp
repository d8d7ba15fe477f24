#include <glibra/classic/matrix4.h>

#include <algorithm>
#include <cstring>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <utility>

#include "base/matrices.h"
#include "classic/label.h"

namespace glibra::classic {
namespace {

using Rows = float[4][4];

/// All arithmetic is that of GLM in double precision; its matrices have columns first.
glm::dmat4 inGlm(const Matrix4& from) {
    glm::dmat4 matrix;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) matrix[j][i] = static_cast<double>(from.GetElement(i, j));
    return matrix;
}

Matrix4 fromGlm(const glm::dmat4& from) {
    Rows rows;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) rows[i][j] = static_cast<float>(from[j][i]);
    return Matrix4(rows);
}

constexpr double wide(float value) {
    return static_cast<double>(value);
}

glm::dvec3 vector(float x, float y, float z) {
    return {wide(x), wide(y), wide(z)};
}

void complain(const char* text) {
    std::fprintf(stderr, "glibra: Matrix4: %s\n", text);
}

}  // namespace

Matrix4::Matrix4() : Matrix4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1) {}
Matrix4::Matrix4(float m00, float m01, float m02, float m03, float m10, float m11, float m12, float m13,
                 float m20, float m21, float m22, float m23, float m30, float m31, float m32, float m33)
    : m_{{m00, m01, m02, m03}, {m10, m11, m12, m13}, {m20, m21, m22, m23}, {m30, m31, m32, m33}} {}
Matrix4::Matrix4(const float m[4][4]) {
    SetMatrix4(m);
}

Matrix4& Matrix4::SetElements(const Matrix4& from) {
    std::memcpy(m_, from.m_, sizeof m_);
    return *this;
}

Matrix4& Matrix4::Multiply(const Matrix4& by) {
    return SetElements(isOpenGLOrder_ ? *this * by : by * *this);
}

Matrix4& Matrix4::OpenGLOrder(bool isOn) {
    isOpenGLOrder_ = isOn;
    return *this;
}

Matrix4& Matrix4::Frustum(float left, float right, float bottom, float top, float near, float far) {
    return FrustumZ(left, right, bottom, top, near, far, near);
}

Matrix4& Matrix4::FrustumZ(float left, float right, float bottom, float top, float near, float far, float z) {
    const double toNear = wide(near) / wide(z);
    return Multiply(
        fromGlm(base::frustumProjection(wide(left) * toNear, wide(right) * toNear, wide(bottom) * toNear,
                                        wide(top) * toNear, wide(near), wide(far))));
}

Matrix4& Matrix4::Ortho(float left, float right, float bottom, float top, float near, float far) {
    return Multiply(fromGlm(
        base::boxProjection(wide(left), wide(right), wide(bottom), wide(top), wide(near), wide(far))));
}

Matrix4& Matrix4::Ortho2D(float left, float right, float bottom, float top) {
    return Ortho(left, right, bottom, top, -1, 1);
}

Matrix4& Matrix4::Perspective(float fovy, float aspect, float near, float far) {
    return Multiply(fromGlm(base::perspectiveProjection(wide(fovy), wide(aspect), wide(near), wide(far))));
}

Matrix4& Matrix4::StereoPerspective(float fovy, float aspect, float near, float far, float z0, float eye) {
    const double half = wide(fovy) / 2;
    const auto top = static_cast<float>(wide(z0) * base::sineOfDegrees(half) / base::cosineOfDegrees(half));
    const float right = top * aspect;
    Matrix4 toEye;
    Matrix4 window;
    toEye.Translatef(-eye, 0, 0);
    window.FrustumZ(-right - eye, right - eye, -top, top, near, far, z0);
    return Multiply(window * toEye);
}

Matrix4& Matrix4::LookAt(float eyeX, float eyeY, float eyeZ, float centreX, float centreY, float centreZ,
                         float upX, float upY, float upZ) {
    const auto view = base::viewingMatrix(vector(eyeX, eyeY, eyeZ), vector(centreX, centreY, centreZ),
                                          vector(upX, upY, upZ));
    if (!view) {
        complain("LookAt: the eye is at the place it looks at, or up is along the line of sight");
        return *this;
    }
    return Multiply(fromGlm(*view));
}

Matrix4& Matrix4::Rotatef(float degrees, float x, float y, float z) {
    return Multiply(fromGlm(base::rotation(wide(degrees), vector(x, y, z))));
}
Matrix4& Matrix4::Scalef(float x, float y, float z) {
    return Multiply(fromGlm(base::scaling(vector(x, y, z))));
}
Matrix4& Matrix4::Translatef(float x, float y, float z) {
    return Multiply(fromGlm(base::translation(vector(x, y, z))));
}

Matrix4& Matrix4::LoadIdentity() {
    return SetElements(Matrix4());
}
Matrix4& Matrix4::Transpose() {
    return SetElements(GetTranspose());
}
Matrix4& Matrix4::Invert() {
    return SetElements(GetInverse());
}
Matrix4& Matrix4::Invert3() {
    return SetElements(GetInverse3());
}

Matrix4 Matrix4::GetTranspose() const {
    return fromGlm(glm::transpose(inGlm(*this)));
}
Matrix4 Matrix4::GetTranspose3() const {
    return fromGlm(glm::dmat4(glm::transpose(glm::dmat3(inGlm(*this)))));
}
Matrix4 Matrix4::GetInverse() const {
    const glm::dmat4 matrix = inGlm(*this);
    if (!base::isSingular(matrix)) return fromGlm(glm::inverse(matrix));
    complain("the matrix has no inverse");
    return *this;
}
Matrix4 Matrix4::GetInverse3() const {
    const glm::dmat3 matrix(inGlm(*this));
    if (!base::isSingular(matrix)) return fromGlm(glm::dmat4(glm::inverse(matrix)));
    complain("the upper left 3 x 3 elements have no inverse");
    return *this;
}
float Matrix4::GetDeterminant() const {
    return static_cast<float>(glm::determinant(inGlm(*this)));
}

Matrix4& Matrix4::SetElement(int i, int j, float value) {
    m_[i & 3][j & 3] = value;
    return *this;
}
void Matrix4::GetMatrix4(float m[4][4]) const {
    std::memcpy(m, m_, sizeof m_);
}
Matrix4& Matrix4::SetMatrix4(const float m[4][4]) {
    std::memcpy(m_, m, sizeof m_);
    return *this;
}
void Matrix4::GetMatrix43(float m[3][3]) const {
    for (int i = 0; i < 3; ++i) std::copy_n(m_[i], 3, m[i]);
}
Matrix4& Matrix4::SetMatrix43(const float m[3][3]) {
    for (int i = 0; i < 3; ++i) std::copy_n(m[i], 3, m_[i]);
    return *this;
}

Matrix4& Matrix4::PushMatrix4() {
    Elements& top = stack_.emplace_back();
    std::memcpy(top.m, m_, sizeof m_);
    return *this;
}
Matrix4& Matrix4::PopMatrix4() {
    if (stack_.empty()) {
        complain("PopMatrix4 without PushMatrix4");
        return *this;
    }
    SetMatrix4(stack_.back().m);
    stack_.pop_back();
    return *this;
}

Vec3 operator*(const Matrix4& m, const Vec3& v) {
    const glm::dvec3 product = glm::dmat3(inGlm(m)) * vector(v.x, v.y, v.z);
    return {static_cast<float>(product.x), static_cast<float>(product.y), static_cast<float>(product.z)};
}
Point3 operator*(const Matrix4& m, const Point3& p) {
    const glm::dvec4 product = inGlm(m) * glm::dvec4(vector(p.x, p.y, p.z), 1);
    const glm::dvec3 place = glm::dvec3(product) / product.w;
    return {static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z)};
}
Matrix4 operator*(const Matrix4& a, const Matrix4& b) {
    Matrix4 product = a;  // with the order and the stack of the left one
    return product.SetElements(fromGlm(inGlm(a) * inGlm(b)));
}

Matrix4& Matrix4::operator*=(float s) {
    for (auto& row : m_)
        for (float& each : row) each *= s;
    return *this;
}
Matrix4& Matrix4::operator+=(const Matrix4& b) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) m_[i][j] += b.m_[i][j];
    return *this;
}
Matrix4& Matrix4::operator+=(float s) {
    for (auto& row : m_)
        for (float& each : row) each += s;
    return *this;
}
Matrix4& Matrix4::operator-=(const Matrix4& b) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) m_[i][j] -= b.m_[i][j];
    return *this;
}

const Matrix4& Matrix4::Print(const char* label, std::FILE* file) const {
    std::fprintf(file, "%s\n", labelled(label).c_str());
    for (const auto& row : m_)
        std::fprintf(file, "  %12.6g %12.6g %12.6g %12.6g\n", static_cast<double>(row[0]),
                     static_cast<double>(row[1]), static_cast<double>(row[2]), static_cast<double>(row[3]));
    return *this;
}
Matrix4& Matrix4::Print(const char* label, std::FILE* file) {
    std::as_const(*this).Print(label, file);
    return *this;
}

void Vec3::Print(const char* label, std::FILE* file) const {
    std::fprintf(file, "%s ( %g, %g, %g )\n", labelled(label).c_str(), wide(x), wide(y), wide(z));
}

}  // namespace glibra::classic
