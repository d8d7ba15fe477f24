// A small renderer for scenes given as signed distances: sphere tracing, one sun with soft shadows, sky light
// with ambient occlusion, one mirror bounce. Slow and plain; it makes the pictures in textures/.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "vec.h"

namespace generate {

// The nearest surface: its distance and the number of its paint.
struct Surface {
    double distance;
    int paint;
};
inline Surface nearer(Surface a, Surface b) {
    return a.distance < b.distance ? a : b;
}

struct Paint {
    Vec3 albedo;       // linear, 0..1
    double gloss = 0;  // strength of the highlight
    double exponent = 40;
    double mirror = 0;  // share of the reflected ray
};

struct Stage {
    Surface (*surface)(Vec3 p);
    Paint (*paint)(int paint, Vec3 p, Vec3 normal);
    Vec3 (*sky)(Vec3 direction);
    Vec3 sunDirection;  // unit vector toward the sun
    Vec3 sunColour;
    Vec3 ambient;  // sky light from above
    double far = 60;
};

struct Camera {
    Vec3 eye, centre;
    double fieldOfView = 40;  // degrees, vertical
    double shift = 0;  // moves the eye to its right by this distance; the plane at the centre stays fixed
};

// 8-bit RGB, top row first.
struct Picture {
    int width, height;
    std::vector<std::uint8_t> rgb;
};

// The light that arrives at `eye` from the unit `direction`, linear.
Vec3 trace(const Stage& stage, Vec3 eye, Vec3 direction, int bounces = 1);

Picture photograph(const Stage& stage, const Camera& camera, int width, int height, int samplesPerSide = 2);

// Face 0..5 = +x, -x, +y, -y, +z, -z of a cube map around `eye`, rows as OpenGL defines them.
Picture cubeFace(const Stage& stage, Vec3 eye, int face, int size, int samplesPerSide = 2);

// Linear light to a display byte.
std::uint8_t displayByte(double linear);

// Writes a PNG. If that fails, prints a message and ends the program.
void writePng(const Picture& picture, const std::string& path);

}  // namespace generate
