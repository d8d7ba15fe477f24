#pragma once
// Vec3 and Point3, classes of the appendix of "Graphics Shaders". docs/classic.md has what the book leaves
// open.

#include <glibra/export.h>

#include <cmath>
#include <cstdio>

namespace glibra::classic {

/// A direction, or any three numbers.
class GLIBRA_API Vec3 {
  public:
    float x = 0, y = 0, z = 0;

    constexpr Vec3(float vx = 0, float vy = 0, float vz = 0) : x(vx), y(vy), z(vz) {}

    constexpr Vec3& operator*=(float s) { return x *= s, y *= s, z *= s, *this; }
    constexpr Vec3& operator+=(const Vec3& b) { return x += b.x, y += b.y, z += b.z, *this; }
    constexpr Vec3& operator-=(const Vec3& b) { return x -= b.x, y -= b.y, z -= b.z, *this; }
    friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr Vec3 operator*(const Vec3& a, float s) { return {a.x * s, a.y * s, a.z * s}; }
    friend constexpr Vec3 operator*(float s, const Vec3& a) { return a * s; }

    [[nodiscard]] constexpr Vec3 Cross(const Vec3& b) const {
        return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
    }
    [[nodiscard]] constexpr float Dot(const Vec3& b) const { return x * b.x + y * b.y + z * b.z; }
    constexpr void GetVec3(float* xyz) const { xyz[0] = x, xyz[1] = y, xyz[2] = z; }
    [[nodiscard]] float Length() const { return std::hypot(x, y, z); }
    /// The vector of length 1 in this direction; the zero vector stays as it is.
    [[nodiscard]] Vec3 Unit() const { return Vec3(*this).Unitize(); }
    /// Makes the length 1, and returns this vector.
    Vec3& Unitize() {
        const float length = Length();
        return length > 0 ? *this = {x / length, y / length, z / length} : *this;
    }
    /// Writes "label: ( x, y, z )" as one line.
    void Print(const char* label = "", std::FILE* file = stderr) const;
};

/// A place. Of two points the difference is a Vec3; a point and a Vec3 give a point.
class GLIBRA_API Point3 : public Vec3 {
  public:
    constexpr Point3(float px = 0, float py = 0, float pz = 0) : Vec3(px, py, pz) {}
    explicit constexpr Point3(const Vec3& v) : Vec3(v) {}

    friend constexpr Vec3 operator-(const Point3& a, const Point3& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend constexpr Point3 operator+(const Point3& a, const Vec3& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend constexpr Point3 operator-(const Point3& a, const Vec3& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
};

}  // namespace glibra::classic
