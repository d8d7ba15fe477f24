// Sphere tracing and shading, see march.h.
#include "march.h"

#include <thread>

namespace generate {
namespace {

constexpr double kNear = 1e-3;

// The distance along the ray to the first surface, or a negative number.
double firstHit(const Stage& stage, Vec3 eye, Vec3 direction, int& paint) {
    double t = kNear;
    for (int step = 0; step < 220 && t < stage.far; ++step) {
        const Surface s = stage.surface(eye + direction * t);
        if (s.distance < 2e-4 * (1 + t)) {
            paint = s.paint;
            return t;
        }
        t += s.distance * 0.85;
    }
    return -1;
}

Vec3 normalAt(const Stage& stage, Vec3 p, double step) {
    const Vec3 corners[] = {{1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {1, 1, 1}};
    Vec3 sum;
    for (const Vec3 c : corners) sum = sum + c * stage.surface(p + c * step).distance;
    return unit(sum);
}

double sunlight(const Stage& stage, Vec3 p) {
    double light = 1, t = 0.02;
    for (int step = 0; step < 64 && t < 12; ++step) {
        const double d = stage.surface(p + stage.sunDirection * t).distance;
        light = std::min(light, 0.5 + 14 * d / t / 2);
        if (light < 0.005) return 0;
        t += std::clamp(d, 0.015, 0.4);
    }
    return smooth(0, 1, light);
}

double openness(const Stage& stage, Vec3 p, Vec3 normal) {
    double closed = 0, weight = 1;
    for (int i = 1; i <= 5; ++i) {
        const double h = 0.07 * i;
        closed += weight * (h - stage.surface(p + normal * h).distance);
        weight *= 0.75;
    }
    return std::clamp(1 - 1.6 * closed, 0.0, 1.0);
}

}  // namespace

Vec3 trace(const Stage& stage, Vec3 eye, Vec3 direction, int bounces) {
    int which = 0;
    const double t = firstHit(stage, eye, direction, which);
    if (t < 0) return stage.sky(direction);
    const Vec3 p = eye + direction * t;
    const Vec3 n = normalAt(stage, p, 4e-4 * (1 + t));
    const Paint paint = stage.paint(which, p, n);
    const Vec3 start = p + n * (2e-3 * (1 + t));
    const double facing = dot(n, stage.sunDirection);
    const double sun = facing > 0 ? facing * sunlight(stage, start) : 0;
    const double open = openness(stage, start, n);
    const Vec3 bounceLight = Vec3{0.10, 0.08, 0.06} * (0.5 - 0.5 * n.y);
    Vec3 light =
        paint.albedo * (stage.sunColour * sun + (stage.ambient * (0.55 + 0.45 * n.y) + bounceLight) * open);
    const Vec3 half = unit(stage.sunDirection - direction);
    light =
        light + stage.sunColour * (paint.gloss * sun * std::pow(std::max(dot(n, half), 0.0), paint.exponent));
    if (paint.mirror > 0 && bounces > 0) {
        const double grazing = std::pow(1 - std::max(-dot(n, direction), 0.0), 5);
        const double share = std::min(paint.mirror + (1 - paint.mirror) * grazing * 0.6, 1.0);
        light = mix(light, trace(stage, start, reflect(direction, n), bounces - 1), share);
    }
    const double haze = 1 - std::exp(-std::pow(t / stage.far, 2) * 1.4);
    return mix(light, stage.sky(direction), haze);
}

std::uint8_t displayByte(double linear) {
    const double x = 0.74 * std::max(linear, 0.0);
    const double mapped =
        x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);  // compresses highlights as film does
    return static_cast<std::uint8_t>(std::lround(255 * std::pow(std::clamp(mapped, 0.0, 1.0), 1 / 2.2)));
}

namespace {

// Two threads draw the even and the odd rows. Every pixel is a pure function of its position.
template <typename Ray>
Picture expose(const Stage& stage, int width, int height, int side, const Ray& ray) {
    Picture picture{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height))};
    const auto rows = [&](int first) {
        for (int y = first; y < height; y += 2)
            for (int x = 0; x < width; ++x) {
                Vec3 sum;
                for (int s = 0; s < side * side; ++s) {
                    const double u = (x + (s % side + 0.5) / side) / width * 2 - 1;
                    const double v = (y + (s / side + 0.5) / side) / height * 2 - 1;
                    const auto [eye, direction] = ray(u, v);
                    const Vec3 light = trace(stage, eye, direction);
                    sum = sum + Vec3{std::min(light.x, 4.0), std::min(light.y, 4.0), std::min(light.z, 4.0)};
                }
                sum = sum * (1.0 / (side * side));
                std::uint8_t* out = &picture.rgb[static_cast<std::size_t>(3 * (y * width + x))];
                out[0] = displayByte(sum.x);
                out[1] = displayByte(sum.y);
                out[2] = displayByte(sum.z);
            }
    };
    std::thread odd(rows, 1);
    rows(0);
    odd.join();
    return picture;
}

struct Ray {
    Vec3 eye, direction;
};

}  // namespace

Picture photograph(const Stage& stage, const Camera& camera, int width, int height, int samplesPerSide) {
    const Vec3 forward = unit(camera.centre - camera.eye);
    const Vec3 right = unit(cross(forward, {0, 1, 0}));
    const Vec3 up = cross(right, forward);
    const double distance = length(camera.centre - camera.eye);
    const double half = distance * std::tan(camera.fieldOfView * 3.14159265358979323846 / 360);
    const Vec3 eye = camera.eye + right * camera.shift;
    return expose(stage, width, height, samplesPerSide, [&](double u, double v) {
        const Vec3 onPlane = camera.centre + right * (u * half * width / height) - up * (v * half);
        return Ray{eye, unit(onPlane - eye)};
    });
}

Picture cubeFace(const Stage& stage, Vec3 eye, int face, int size, int samplesPerSide) {
    return expose(stage, size, size, samplesPerSide, [&](double u, double v) {
        const Vec3 directions[] = {{1, -v, -u}, {-1, -v, u}, {u, 1, v},
                                   {u, -1, -v}, {u, -v, 1},  {-u, -v, -1}};
        return Ray{eye, unit(directions[face])};
    });
}

}  // namespace generate
