// Signed distances of simple bodies, negative inside, and the ways to combine them.
#pragma once

#include "vec.h"

namespace generate {

inline double sphere(Vec3 p, double radius) {
    return length(p) - radius;
}
// An approximate distance. Its zero is exactly the ellipsoid, and near it the error is of second order.
inline double ellipsoid(Vec3 p, Vec3 radii) {
    const Vec3 q = {p.x / radii.x, p.y / radii.y, p.z / radii.z};
    const Vec3 g = {q.x / radii.x, q.y / radii.y, q.z / radii.z};
    const double k = length(q), slope = length(g);
    return slope < 1e-9 ? -std::min({radii.x, radii.y, radii.z}) : k * (k - 1) / slope;
}
// A box from -h to h with edges rounded by r.
inline double box(Vec3 p, Vec3 h, double r = 0) {
    const Vec3 q = {std::abs(p.x) - h.x + r, std::abs(p.y) - h.y + r, std::abs(p.z) - h.z + r};
    const Vec3 outside = {std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
    return length(outside) + std::min(std::max({q.x, q.y, q.z}), 0.0) - r;
}
// A round-ended stick from a to b whose radius changes linearly from ra to rb.
inline double stick(Vec3 p, Vec3 a, Vec3 b, double ra, double rb) {
    const Vec3 along = b - a;
    const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
    return length(p - (a + along * t)) - mix(ra, rb, t);
}
// A ring in the XZ plane.
inline double ring(Vec3 p, double radius, double tube) {
    return std::hypot(std::hypot(p.x, p.z) - radius, p.y) - tube;
}
// An upright cylinder from -h to h.
inline double cylinder(Vec3 p, double radius, double h) {
    const double across = std::hypot(p.x, p.z) - radius, up = std::abs(p.y) - h;
    return std::hypot(std::max(across, 0.0), std::max(up, 0.0)) + std::min(std::max(across, up), 0.0);
}
// An upright cone with its base at y = 0.
inline double cone(Vec3 p, double radius, double height) {
    const double slant = std::hypot(radius, height);
    const double side = (std::hypot(p.x, p.z) * height + (p.y - height) * radius) / slant;
    return std::max(side, -p.y);
}

// The union of two bodies with a fillet of about the width k.
inline double blend(double a, double b, double k) {
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    return std::min(a, b) - h * h * k / 4;
}
inline Vec3 turnY(Vec3 p, double degrees) {
    const double a = degrees * 3.14159265358979323846 / 180, c = std::cos(a), s = std::sin(a);
    return {c * p.x + s * p.z, p.y, -s * p.x + c * p.z};
}
inline Vec3 turnX(Vec3 p, double degrees) {
    const double a = degrees * 3.14159265358979323846 / 180, c = std::cos(a), s = std::sin(a);
    return {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
}
inline Vec3 turnZ(Vec3 p, double degrees) {
    const double a = degrees * 3.14159265358979323846 / 180, c = std::cos(a), s = std::sin(a);
    return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

}  // namespace generate
