// The algebra that the generators of pictures and models share: three-vectors, mixing, and noise. Randomness
// is an integer hash of the lattice point, so that every machine makes the same files.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace generate {

struct Vec3 {
    double x = 0, y = 0, z = 0;
};

inline Vec3 operator+(Vec3 a, Vec3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(Vec3 a, Vec3 b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline Vec3 operator*(Vec3 a, double s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline double dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 a) {
    return std::sqrt(dot(a, a));
}
inline Vec3 unit(Vec3 a) {
    return a * (1 / length(a));
}
inline Vec3 reflect(Vec3 incident, Vec3 normal) {
    return incident - normal * (2 * dot(incident, normal));
}

inline double mix(double a, double b, double t) {
    return a + (b - a) * t;
}
inline Vec3 mix(Vec3 a, Vec3 b, double t) {
    return a + (b - a) * t;
}
// 0 below a, 1 above b, a cubic in between; requires a < b.
inline double smooth(double a, double b, double x) {
    const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}
inline double fract(double x) {
    return x - std::floor(x);
}

// A well-mixed 32-bit number for three lattice indices and a stream number.
inline std::uint32_t hash(int i, int j, int k, std::uint32_t stream = 0) {
    std::uint32_t h = static_cast<std::uint32_t>(i) * 0x8da6b343U ^
                      static_cast<std::uint32_t>(j) * 0xd8163841U ^
                      static_cast<std::uint32_t>(k) * 0xcb1ab31fU ^ stream * 0x9e3779b9U;
    h = (h ^ (h >> 16)) * 0x7feb352dU;
    h = (h ^ (h >> 15)) * 0x846ca68bU;
    return h ^ (h >> 16);
}
// The same as a number in 0 <= x < 1.
inline double random(int i, int j, int k = 0, std::uint32_t stream = 0) {
    return (hash(i, j, k, stream) >> 8) / 16777216.0;
}

// Value noise in 0..1 on the unit lattice, cubic weights.
inline double noise(Vec3 p, std::uint32_t stream = 0) {
    const double fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
    const int i = static_cast<int>(fx), j = static_cast<int>(fy), k = static_cast<int>(fz);
    const double u = smooth(0, 1, p.x - fx), v = smooth(0, 1, p.y - fy), w = smooth(0, 1, p.z - fz);
    const auto row = [&](int b, int c) {
        return mix(random(i, j + b, k + c, stream), random(i + 1, j + b, k + c, stream), u);
    };
    return mix(mix(row(0, 0), row(1, 0), v), mix(row(0, 1), row(1, 1), v), w);
}
// A sum of octaves of noise, each with twice the frequency and half the amplitude of the one before, scaled
// to 0..1.
inline double turbulence(Vec3 p, int octaves, std::uint32_t stream = 0) {
    double sum = 0, amplitude = 1, total = 0;
    for (int o = 0; o < octaves; ++o) {
        sum += amplitude * noise(p, stream + static_cast<std::uint32_t>(o));
        total += amplitude;
        amplitude /= 2;
        p = p * 2.02;
    }
    return sum / total;
}

}  // namespace generate
