// The room for stereo pairs and the courtyard for cube maps.
#include "distance.h"
#include "stages.h"

namespace generate {
namespace {

// ---- Room
// ---------------------------------------------------------------------------------------------------

enum RoomPaint { parquet, plaster, pillar, hoop, blueBall, orangeBall, crate, glass };

Surface roomSurface(Vec3 p) {
    Surface s{p.y, parquet};
    s = nearer(s, {std::min({p.z + 6, 4.2 - std::abs(p.x), 4.4 - p.y}), plaster});
    for (const double z : {-4.6, -1.8, 1.0})
        for (const double side : {-1.0, 1.0}) {
            const Vec3 q = p - Vec3{3.1 * side, 0, z};
            const double shaft =
                cylinder(q - Vec3{0, 2.2, 0}, 0.30, 2.2) + 0.012 * std::cos(16 * std::atan2(q.z, q.x));
            s = nearer(s, {std::min(shaft, box(q - Vec3{0, 0.1, 0}, {0.45, 0.15, 0.45}, 0.03)), pillar});
        }
    s = nearer(s, {ring(turnX(turnY(p - Vec3{-0.75, 2.2, 1.6}, 35), 70), 0.75, 0.12), hoop});
    s = nearer(s, {ring(turnX(turnY(p - Vec3{-0.25, 2.35, 1.0}, -40), 80), 0.6, 0.10), hoop});
    s = nearer(s, {sphere(p - Vec3{1.35, 0.6, 1.3}, 0.6), orangeBall});
    s = nearer(s, {sphere(p - Vec3{-1.5, 0.85, -1.4}, 0.85), blueBall});
    s = nearer(s, {sphere(p - Vec3{0.5, 2.3, -3.3}, 0.7), glass});
    s = nearer(s, {box(turnY(p - Vec3{0.35, 0.5, -0.9}, 25), {0.5, 0.5, 0.5}, 0.04), crate});
    return nearer(s, {box(turnY(p - Vec3{0.45, 1.3, -0.95}, -12), {0.32, 0.32, 0.32}, 0.04), crate});
}

Paint roomPaint(int paint, Vec3 p, Vec3) {
    switch (paint) {
        case pillar:
            return {Vec3{0.66, 0.60, 0.50} * (0.8 + 0.3 * turbulence({p.x * 3, p.y * 1.2, p.z * 3}, 4, 3)),
                    0.2};
        case hoop:
            return {{0.62, 0.40, 0.08}, 1.2, 60, 0.35};
        case blueBall:
            return {{0.04, 0.14, 0.45}, 0.8, 90, 0.08};
        case orangeBall:
            return {{0.70, 0.22, 0.03}, 0.8, 90, 0.05};
        case glass:
            return {{0.25, 0.30, 0.30}, 1.2, 200, 0.6};
        case crate: {
            const double board = fract(p.y * 4) < 0.06 ? 0.4 : 1.0;
            return {mix(Vec3{0.42, 0.25, 0.11}, Vec3{0.30, 0.17, 0.07},
                        turbulence({p.x * 2, p.y * 20, p.z * 2}, 3, 6)) *
                    board};
        }
        case plaster: {
            const bool back = p.z < -5.9;
            const bool window = back && std::abs(std::abs(p.x) - 1.6) < 0.75 && p.y > 1.2 && p.y < 3.4;
            const bool bar =
                std::abs(fract(p.x * 1.33 - 0.04) - 0.5) < 0.03 || std::abs(fract(p.y * 1.37) - 0.5) < 0.03;
            if (window && !bar) return {{0.9, 1.2, 1.7}};
            const double dado = p.y < 0.9 ? 1.0 : 0.0;
            return {mix(Vec3{0.58, 0.52, 0.42}, Vec3{0.16, 0.24, 0.20}, dado) *
                    (0.88 + 0.2 * turbulence(p * 2.2, 4, 9))};
        }
        default:
            break;
    }
    const bool dark = (static_cast<int>(std::floor(p.x)) + static_cast<int>(std::floor(p.z))) & 1;
    return {(dark ? Vec3{0.20, 0.10, 0.05} : Vec3{0.48, 0.36, 0.22}) * (0.85 + 0.25 * noise(p * 7, 4)), 0.3,
            40, 0.10};
}

Vec3 roomSky(Vec3 d) {
    return mix(Vec3{0.35, 0.36, 0.40}, Vec3{0.75, 0.78, 0.85}, 0.5 + 0.5 * d.y);
}

// ---- Courtyard
// ----------------------------------------------------------------------------------------------

enum CourtPaint { tiles, court, column, tileRoof, hedge, basin };

Surface courtSurface(Vec3 p) {
    Surface s{p.y, tiles};
    const double ax = std::abs(p.x), az = std::abs(p.z);
    s = nearer(s, {std::max(9.0 - std::max(ax, az), p.y - 4.6), court});
    // The columns are 2 apart on a square from -6 to 6. An entablature with arches joins them.
    const double gx = std::clamp(std::round(p.x / 2) * 2, -6.0, 6.0),
                 gz = std::clamp(std::round(p.z / 2) * 2, -6.0, 6.0);
    const Vec3 onX = {p.x - gx, p.y - 1.3, az - 6}, onZ = {ax - 6, p.y - 1.3, p.z - gz};
    double columns = std::min(cylinder(onX, 0.19, 1.3), cylinder(onZ, 0.19, 1.3));
    columns = std::min({columns, box(onX + Vec3{0, 1.2, 0}, {0.3, 0.12, 0.3}, 0.02),
                        box(onZ + Vec3{0, 1.2, 0}, {0.3, 0.12, 0.3}, 0.02),
                        box(onX - Vec3{0, 1.3, 0}, {0.3, 0.1, 0.3}, 0.02),
                        box(onZ - Vec3{0, 1.3, 0}, {0.3, 0.1, 0.3}, 0.02)});
    const double frame = std::max(std::abs(std::max(ax, az) - 6) - 0.24, std::abs(p.y - 3.3) - 0.75);
    const double mid = az > ax ? p.x : p.z;
    const double archX = std::abs(fract(mid / 2) - 0.5) * 2 * 1.0, arch = std::hypot(archX, p.y - 2.6) - 0.78;
    columns = std::min(columns, std::max(frame, -arch) * 0.8);
    s = nearer(s, {columns, column});
    const double out = std::max(ax, az) - 6.0;
    const double slope = (p.y - 4.1 - 0.28 * out) * 0.96;
    s = nearer(s, {std::max({std::abs(slope) - 0.08, -out - 0.5, out - 3.2}), tileRoof});
    const Vec3 bed = {ax - 3.6, p.y - 0.25, az - 3.6};
    s = nearer(s, {box(bed, {0.85, 0.25, 0.85}, 0.03), basin});
    const double bush = ellipsoid(bed - Vec3{0, 0.65, 0}, {0.75, 0.85, 0.75}) +
                        0.16 * (noise(p * 5, 2) - 0.5) + 0.08 * (noise(p * 12, 3) - 0.5);
    return nearer(s, {bush * 0.6, hedge});
}

Paint courtPaint(int paint, Vec3 p, Vec3 n) {
    switch (paint) {
        case column:
            return {Vec3{0.72, 0.64, 0.52} * (0.85 + 0.25 * turbulence(p * 2.5, 4, 3)), 0.15};
        case basin:
            return {Vec3{0.50, 0.46, 0.40} * (0.8 + 0.3 * noise(p * 6, 8))};
        case hedge: {
            const bool flower = noise(p * 16, 5) > 0.84;
            const Vec3 bloom = p.x * p.z > 0 ? Vec3{0.65, 0.06, 0.20} : Vec3{0.75, 0.60, 0.08};
            return {flower ? bloom : mix(Vec3{0.05, 0.13, 0.02}, Vec3{0.13, 0.23, 0.05}, noise(p * 4, 6))};
        }
        case tileRoof: {
            const double u = std::abs(p.x) > std::abs(p.z) ? p.z : p.x;
            return {Vec3{0.50, 0.17, 0.07} *
                    (0.65 + 0.35 * std::abs(std::sin(u * 9)) + 0.2 * (noise(p * 5, 7) - 0.5))};
        }
        case court: {
            // Each wall has its own colour, so that a reflection shows where it comes from.
            const bool x = std::abs(p.x) > std::abs(p.z);
            const Vec3 tint = x ? (p.x > 0 ? Vec3{0.62, 0.22, 0.10} : Vec3{0.12, 0.28, 0.44})
                                : (p.z > 0 ? Vec3{0.62, 0.46, 0.14} : Vec3{0.56, 0.50, 0.42});
            const double u = x ? p.z : p.x;
            const bool door = std::abs(fract(u / 4 + 0.5) - 0.5) < 0.16 && p.y < 2.3;
            if (door) return {{0.09, 0.05, 0.025}, 0.2};
            const bool dado = p.y < 1.0;
            const double check =
                (static_cast<int>(std::floor(u * 4)) + static_cast<int>(std::floor(p.y * 4))) & 1;
            return {dado ? mix(Vec3{0.06, 0.16, 0.30}, Vec3{0.70, 0.68, 0.60}, check)
                         : tint * (0.85 + 0.25 * turbulence(p * 1.8, 4, 9))};
        }
        default:
            break;
    }
    const double fx = std::abs(fract(p.x) - 0.5), fz = std::abs(fract(p.z) - 0.5);
    const int i = static_cast<int>(std::floor(p.x)), j = static_cast<int>(std::floor(p.z));
    const Vec3 light = {0.58, 0.50, 0.40}, dark = {0.34, 0.12, 0.07};
    Vec3 c = fx + fz < 0.32 ? dark : light * (0.85 + 0.25 * random(i, j));
    if (fx > 0.475 || fz > 0.475) c = {0.22, 0.19, 0.16};
    return {c * (0.85 + 0.25 * noise(p * 5, 4)) * (n.y > 0 ? 1.0 : 0.9), 0.2, 30, 0.03};
}

Vec3 courtSky(Vec3 d) {
    const Vec3 base =
        mix(Vec3{0.66, 0.76, 0.88}, Vec3{0.10, 0.26, 0.64}, std::sqrt(std::clamp(d.y * 1.2, 0.0, 1.0)));
    if (d.y < 0.02) return base;
    const Vec3 p = d * (1 / (d.y + 0.2));
    const double c = turbulence({p.x * 1.5, 1.2, p.z * 1.5}, 5, 44);
    const double sun = std::pow(std::max(dot(d, unit(Vec3{0.45, 0.75, 0.5})), 0.0), 400);
    return mix(base, Vec3{1, 1, 1}, smooth(0.46, 0.72, c)) + Vec3{3, 2.7, 2.2} * sun;
}

}  // namespace

Stage roomStage() {
    return {roomSurface,      roomPaint,         roomSky, unit(Vec3{-0.32, 0.36, 0.90}),
            {2.7, 2.45, 2.1}, {0.62, 0.64, 0.70}};
}
Stage courtyardStage() {
    return {courtSurface,     courtPaint,         courtSky, unit(Vec3{0.45, 0.75, 0.5}),
            {2.5, 2.3, 1.95}, {0.45, 0.55, 0.70}, 90};
}

}  // namespace generate
