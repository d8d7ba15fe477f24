#pragma once
// Matrix4, a class of the appendix of "Graphics Shaders". docs/classic.md has what the book leaves open.

#include <glibra/classic/vec3.h>

#include <cstdio>
#include <vector>

namespace glibra::classic {

/// A matrix of 4 x 4 floats for column vectors. Row i and column j count from 0, everywhere in this class: a
/// float[4][4] is the matrix as one writes it down, and the translation is in column 3.
///
/// Rotatef() and its kin multiply from the left: transforms take effect in the order in which they are
/// called. After OpenGLOrder(true) they multiply from the right, as glRotatef() does. All of them return
/// *this.
class GLIBRA_API Matrix4 {
  public:
    Matrix4();  ///< the identity
    Matrix4(float m00, float m01, float m02, float m03, float m10, float m11, float m12, float m13, float m20,
            float m21, float m22, float m23, float m30, float m31, float m32, float m33);
    explicit Matrix4(const float m[4][4]);

    /// Decides how the functions up to Translatef() multiply this matrix from now on.
    Matrix4& OpenGLOrder(bool isOn = true);
    Matrix4& Frustum(float left, float right, float bottom, float top, float near, float far);
    /// A frustum through a window that is given at the distance z from the eye instead of near.
    Matrix4& FrustumZ(float left, float right, float bottom, float top, float near, float far, float z);
    Matrix4& Ortho(float left, float right, float bottom, float top, float near, float far);
    Matrix4& Ortho2D(float left, float right, float bottom, float top);
    /// `fovy` is the vertical angle in degrees.
    Matrix4& Perspective(float fovy, float aspect, float near, float far);
    /// The eye stands `eye` to the right of the middle (negative: the left eye), and looks through the same
    /// window at the distance z0, where both eyes see the same.
    Matrix4& StereoPerspective(float fovy, float aspect, float near, float far, float z0, float eye);
    Matrix4& LookAt(float eyeX, float eyeY, float eyeZ, float centreX, float centreY, float centreZ,
                    float upX, float upY, float upZ);
    Matrix4& Rotatef(float degrees, float x, float y, float z);
    Matrix4& Scalef(float x, float y, float z);
    Matrix4& Translatef(float x, float y, float z);

    Matrix4& LoadIdentity();
    Matrix4& Transpose();
    /// A matrix without an inverse stays as it is; a message on standard error says so.
    Matrix4& Invert();
    /// The inverse of the upper left 3 x 3 elements; the others become those of the identity.
    Matrix4& Invert3();
    [[nodiscard]] Matrix4 GetTranspose() const;
    [[nodiscard]] Matrix4 GetTranspose3() const;
    [[nodiscard]] Matrix4 GetInverse() const;
    [[nodiscard]] Matrix4 GetInverse3() const;
    [[nodiscard]] float GetDeterminant() const;
    [[nodiscard]] float GetElement(int i, int j) const { return m_[i & 3][j & 3]; }
    Matrix4& SetElement(int i, int j, float value);
    void GetMatrix4(float m[4][4]) const;
    Matrix4& SetMatrix4(const float m[4][4]);
    /// The upper left 3 x 3 elements.
    void GetMatrix43(float m[3][3]) const;
    Matrix4& SetMatrix43(const float m[3][3]);

    /// Each matrix has a stack of its own.
    Matrix4& PushMatrix4();
    Matrix4& PopMatrix4();

    /// The same as matrix * vector.
    [[nodiscard]] Vec3 MultBy(const Vec3& v) const { return *this * v; }
    [[nodiscard]] Point3 MultBy(const Point3& p) const { return *this * p; }
    /// A Vec3 is a direction, which no translation moves.
    friend GLIBRA_API Vec3 operator*(const Matrix4& m, const Vec3& v);
    /// A Point3 is a place: it is moved, and divided by w.
    friend GLIBRA_API Point3 operator*(const Matrix4& m, const Point3& p);
    friend GLIBRA_API Matrix4 operator*(const Matrix4& a, const Matrix4& b);
    Matrix4& operator*=(const Matrix4& b) { return SetElements(*this * b); }
    Matrix4& operator*=(float s);
    Matrix4& operator+=(const Matrix4& b);
    Matrix4& operator+=(float s);  ///< to each element
    Matrix4& operator-=(const Matrix4& b);
    Matrix4& operator-=(float s) { return *this += -s; }
    friend Matrix4 operator*(Matrix4 a, float s) { return a *= s; }
    friend Matrix4 operator*(float s, Matrix4 a) { return a *= s; }
    friend Matrix4 operator+(Matrix4 a, const Matrix4& b) { return a += b; }
    friend Matrix4 operator+(Matrix4 a, float s) { return a += s; }
    friend Matrix4 operator-(Matrix4 a, const Matrix4& b) { return a -= b; }
    friend Matrix4 operator-(Matrix4 a, float s) { return a -= s; }
    friend Matrix4 operator-(Matrix4 a) { return a *= -1; }

    /// Writes the label, with a colon unless it ends with one or with an equals sign, and four rows; returns
    /// this matrix.
    const Matrix4& Print(const char* label = "", std::FILE* file = stderr) const;
    Matrix4& Print(const char* label = "", std::FILE* file = stderr);

  private:
    struct Elements {
        float m[4][4];
    };
    Matrix4& SetElements(const Matrix4& from);  // the elements alone: neither the order nor the stack
    Matrix4& Multiply(const Matrix4& by);

    float m_[4][4];
    bool isOpenGLOrder_ = false;
    std::vector<Elements> stack_;
};

}  // namespace glibra::classic
