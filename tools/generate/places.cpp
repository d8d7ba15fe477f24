// The lake, the village and the planet: landscapes under an open sky.
#include "distance.h"
#include "stages.h"

namespace generate {
namespace {

Vec3 clouds(Vec3 d, Vec3 base, Vec3 cloud, double cover) {
    if (d.y < 0.02) return base;
    const Vec3 p = d * (1 / (d.y + 0.15));
    const double c = turbulence({p.x * 1.3, 3.7, p.z * 1.3}, 5, 40);
    return mix(base, cloud, smooth(1 - cover, 1.25 - cover, c) * smooth(0.02, 0.2, d.y));
}

// ---- Lake
// ---------------------------------------------------------------------------------------------------

enum LakePaint { water, rock, fir };

double mountains(double x, double z) {
    const double back = smooth(-4, -26, z), side = smooth(2.5, 13, std::abs(x));
    const double ridge = 1 - std::abs(2 * turbulence({x * 0.13, 0.5, z * 0.13}, 5, 3) - 1);
    return -0.35 + (9.5 * back + 3.0 * side) * ridge * ridge * 0.85 +
           0.5 * smooth(3.2, 4.5, std::abs(x + 0.4 * std::sin(z)) + smooth(-6, -14, z) * 4) * (1 - back);
}

Surface lakeSurface(Vec3 p) {
    const double ripple = 0.010 * noise({p.x * 3, 0, p.z * 9}, 6) + 0.006 * noise({p.x * 9, 5, p.z * 24}, 8);
    Surface s{p.y - ripple, water};
    const double ground = mountains(p.x, p.z);
    s = nearer(s, {(p.y - ground) * 0.45, rock});
    const int i0 = static_cast<int>(std::floor(p.x / 0.9)), j0 = static_cast<int>(std::floor(p.z / 0.9));
    if (p.y < ground + 2.5 && p.z > -22)
        for (int i = i0 - 1; i <= i0 + 1; ++i)
            for (int j = j0 - 1; j <= j0 + 1; ++j) {
                const double x = (i + 0.2 + 0.6 * random(i, j, 1)) * 0.9,
                             z = (j + 0.2 + 0.6 * random(i, j, 2)) * 0.9;
                const double foot = mountains(x, z);
                if (foot < 0.05 || foot > 2.4 || random(i, j, 3) < 0.25) continue;
                const double tall = 0.9 + 0.8 * random(i, j, 4);
                const Vec3 q = p - Vec3{x, foot - 0.1, z};
                const double layers = 0.06 * std::abs(fract(q.y / tall * 5) - 0.5);
                s = nearer(s, {(cone(q, 0.27 * tall, tall) + layers) * 0.6, fir});
            }
    return s;
}

Vec3 lakeSky(Vec3 d) {
    const Vec3 horizon = {0.95, 0.52, 0.28}, zenith = {0.10, 0.19, 0.42};
    const Vec3 base = mix(horizon, zenith, std::pow(std::clamp(d.y * 1.6, 0.0, 1.0), 0.6));
    const double glow = std::pow(std::max(dot(d, unit(Vec3{-0.45, 0.20, -1})), 0.0), 24);
    return clouds(d, base + Vec3{0.9, 0.45, 0.15} * glow, {1.0, 0.58, 0.45}, 0.52);
}

Paint lakePaint(int paint, Vec3 p, Vec3 n) {
    if (paint == water) return {{0.015, 0.04, 0.05}, 0.4, 200, 0.45};
    if (paint == fir) return {Vec3{0.025, 0.06, 0.022} * (0.6 + 0.8 * noise(p * 9, 2))};
    const double snow = smooth(0.52, 0.72, n.y) * smooth(2.6, 3.6, p.y + 1.4 * noise(p * 1.3, 4));
    const double grass = smooth(0.55, 0.8, n.y) * smooth(2.6, 1.2, p.y);
    Vec3 c = mix(Vec3{0.16, 0.13, 0.12}, Vec3{0.27, 0.23, 0.20}, turbulence(p * 2.5, 3, 7));
    c = mix(c, mix(Vec3{0.10, 0.13, 0.03}, Vec3{0.20, 0.18, 0.05}, noise(p * 2, 12)), grass);
    return {mix(c, Vec3{0.80, 0.82, 0.88}, snow)};
}

// ---- Village
// ------------------------------------------------------------------------------------------------

enum VillagePaint { meadow, wall, roof, tree, path, spire };

double meadowHeight(double x, double z) {
    const double hills = smooth(-6, -22, z);
    return 0.25 * std::sin(x * 0.35 + 1) * std::cos(z * 0.3) +
           7 * hills * turbulence({x * 0.12, 0.2, z * 0.12}, 4, 21);
}

struct House {
    double x, z, turn, wide, tall, deep;
};
constexpr House kHouses[] = {{-3.4, 2.2, 18, 0.85, 0.75, 1.15},  {-1.5, 0.4, -25, 0.75, 0.70, 1.00},
                             {1.9, 1.7, 12, 0.95, 0.85, 1.25},   {3.9, -0.4, -30, 0.80, 0.75, 1.05},
                             {-4.6, -1.6, 40, 0.80, 0.70, 1.00}, {-2.6, -3.2, 5, 0.75, 0.75, 1.05},
                             {2.4, -3.0, 25, 0.85, 0.70, 1.10},  {5.4, -3.6, -10, 0.80, 0.80, 1.00},
                             {-6.6, 0.8, -15, 0.85, 0.75, 1.10}, {6.3, 1.4, 20, 0.85, 0.80, 1.10},
                             {-5.4, -5.2, 15, 0.80, 0.70, 1.0},  {4.6, -6.0, 35, 0.8, 0.7, 1.0}};

Vec3 inHouse(const House& h, Vec3 p) {
    return turnY(p - Vec3{h.x, meadowHeight(h.x, h.z), h.z}, h.turn);
}

double pathCentre(double z) {
    return 0.3 + 0.9 * std::sin(z * 0.55);
}

Surface villageSurface(Vec3 p) {
    const double ground = meadowHeight(p.x, p.z);
    Surface s{(p.y - ground) * 0.7, meadow};
    int index = 0;
    for (const House& h : kHouses) {
        const Vec3 q = inHouse(h, p);
        const double around = length(q) - 2.4;
        if (around > 0.3) {
            s = nearer(s, {around, wall});
        } else {
            s = nearer(s, {box(q, {h.wide, h.tall, h.deep}), wall + 10 * index});
            const double slope = (std::abs(q.x) * 0.78 + (q.y - h.tall) * 0.62) - h.wide * 0.86;
            const double prism = std::max({slope, std::abs(q.z) - h.deep - 0.12, h.tall - 0.12 - q.y});
            const double under = (std::abs(q.x) * 0.78 + (q.y - h.tall) * 0.62) - h.wide * 0.74;
            s = nearer(s, {std::max(prism, -std::max(under, std::abs(q.z) - h.deep + 0.05)) * 0.9,
                           roof + 10 * index});
            s = nearer(s, {box(q - Vec3{0.4, h.tall + 0.75, 0.3}, {0.1, 0.4, 0.1}), wall + 10 * index});
        }
        ++index;
    }
    const Vec3 c = p - Vec3{0.6, meadowHeight(0.6, -5.4), -5.4};
    s = nearer(s, {box(c - Vec3{0, 1.2, 0}, {0.6, 1.6, 0.6}), wall + 10 * index});
    s = nearer(s, {cone(c - Vec3{0, 2.75, 0}, 0.95, 2.6), spire});
    s = nearer(s, {box(c - Vec3{1.6, 0.4, 0}, {1.4, 0.9, 0.8}), wall + 10 * index});
    const Vec3 q = c - Vec3{1.6, 1.3, 0};
    s = nearer(s, {std::max({std::abs(q.z) * 0.75 + q.y * 0.66 - 0.68, std::abs(q.x) - 1.5, -q.y}), roof});
    const double cell = 1.7;
    const int i0 = static_cast<int>(std::floor(p.x / cell)), j0 = static_cast<int>(std::floor(p.z / cell));
    if (p.y < ground + 3)
        for (int i = i0 - 1; i <= i0 + 1; ++i)
            for (int j = j0 - 1; j <= j0 + 1; ++j) {
                const bool wood = j * cell < -8.5;
                if (random(i, j, 1) > (wood ? 0.95 : 0.22)) continue;
                const double x = (i + 0.25 + 0.5 * random(i, j, 2)) * cell,
                             z = (j + 0.25 + 0.5 * random(i, j, 3)) * cell;
                if (std::abs(x - pathCentre(z)) < 1.0 || std::hypot(x - 1.3, z + 5.4) < 2.2 || z > 4)
                    continue;
                bool free = true;
                for (const House& h : kHouses) free = free && std::hypot(x - h.x, z - h.z) > 1.5;
                if (!free) continue;
                const double r = 0.55 + 0.3 * random(i, j, 4);
                const Vec3 t = p - Vec3{x, meadowHeight(x, z) + r * 1.1, z};
                if (length(t) > 1.7) {
                    s = nearer(s, {length(t) - 1.5, tree});
                    continue;
                }
                const double leaves = ellipsoid(t, {r, r * 1.2, r}) + 0.22 * (noise(t * 5, 31) - 0.5) +
                                      0.10 * (noise(t * 13, 32) - 0.5);
                s = nearer(s, {leaves * 0.6, tree});
            }
    return s;
}

Paint villagePaint(int paint, Vec3 p, Vec3 n) {
    const int kind = paint % 10, index = paint / 10;
    if (kind == roof) {
        const double tile = 0.75 + 0.25 * fract(p.y * 7) * (0.7 + 0.6 * noise(p * 8, 14));
        return {mix(Vec3{0.46, 0.10, 0.04}, Vec3{0.36, 0.13, 0.06}, random(index, 2)) * tile};
    }
    if (kind == spire) return {{0.12, 0.17, 0.18}, 0.2, 20};
    if (kind == tree) return {mix(Vec3{0.05, 0.13, 0.02}, Vec3{0.14, 0.22, 0.04}, noise(p * 3, 15))};
    if (kind == wall) {
        const Vec3 tints[] = {{0.72, 0.66, 0.54}, {0.70, 0.55, 0.36}, {0.74, 0.72, 0.66}, {0.62, 0.48, 0.40}};
        Vec3 c = tints[hash(index, 7, 0) % 4];
        if (index < static_cast<int>(std::size(kHouses))) {
            const House& h = kHouses[index];
            const Vec3 q = inHouse(h, p);
            const bool end = std::abs(q.x) < h.wide * 0.98;
            const double across = (end ? q.x / h.wide : q.z / h.deep) * 1.5;
            const bool pane = std::abs(fract(across) - 0.5) < 0.17 && std::abs(q.y - 0.32) < 0.2;
            const bool frame = std::abs(fract(across) - 0.5) < 0.22 && std::abs(q.y - 0.32) < 0.26;
            if (frame) c = {0.75, 0.74, 0.70};
            if (pane) return {{0.03, 0.045, 0.06}, 1.0, 80, 0.15};
        } else if (std::abs(n.y) < 0.5) {
            const Vec3 q = p - Vec3{0.6, meadowHeight(0.6, -5.4), -5.4};
            if (std::hypot(q.x, q.y - 2.3) < 0.3 && q.z > 0.5) return {{0.04, 0.04, 0.05}};
        }
        return {c * (0.9 + 0.15 * noise(p * 6, 3))};
    }
    const double onPath =
        smooth(0.62, 0.48, std::abs(p.x - pathCentre(p.z)) + 0.15 * noise(p * 4, 8)) * smooth(-7, -5, p.z);
    Vec3 grass = mix(Vec3{0.13, 0.21, 0.03}, Vec3{0.24, 0.27, 0.06}, turbulence(p * 0.8, 4, 18));
    grass = grass * (0.75 + 0.5 * noise(p * 14, 19));
    if (random(static_cast<int>(std::floor(p.x * 9)), static_cast<int>(std::floor(p.z * 9)), 0, 5) > 0.985)
        grass = {0.75, 0.60, 0.12};
    return {mix(grass, Vec3{0.44, 0.36, 0.25}, onPath)};
}

Vec3 daySky(Vec3 d) {
    const Vec3 base =
        mix(Vec3{0.62, 0.74, 0.88}, Vec3{0.12, 0.28, 0.66}, std::sqrt(std::clamp(d.y * 1.3, 0.0, 1.0)));
    return clouds(d, base, {0.98, 0.98, 1.0}, 0.60);
}

// ---- Planet
// -------------------------------------------------------------------------------------------------

Surface nothing(Vec3) {
    return {1e3, 0};
}
Paint noPaint(int, Vec3, Vec3) {
    return {};
}
Vec3 planetColour(Vec3 d) {
    const double land = turbulence(d * 2.1 + Vec3{4.3, 1.7, 2.9}, 7, 60) - 0.5;
    const double latitude = std::abs(d.y) + 0.12 * (turbulence(d * 6, 4, 70) - 0.5);
    const Vec3 sea = mix(Vec3{0.02, 0.10, 0.24}, Vec3{0.05, 0.26, 0.38}, smooth(-0.12, 0, land));
    const Vec3 forest = mix(Vec3{0.07, 0.20, 0.04}, Vec3{0.16, 0.26, 0.06}, turbulence(d * 9, 4, 80));
    Vec3 ground = mix(forest, Vec3{0.46, 0.35, 0.16}, smooth(0.25, 0.12, std::abs(latitude - 0.33)));
    ground = mix(ground, Vec3{0.28, 0.20, 0.13}, smooth(0.10, 0.20, land));
    Vec3 c = land > 0 ? ground : sea;
    c = mix(c, Vec3{0.85, 0.88, 0.92}, smooth(0.91, 0.94, latitude));
    return c * 1.3;
}

}  // namespace

Stage lakeStage() {
    return {lakeSurface,       lakePaint,          lakeSky, unit(Vec3{-0.75, 0.38, -0.35}),
            {2.6, 1.75, 1.05}, {0.34, 0.38, 0.50}, 60};
}
Stage villageStage() {
    return {villageSurface,   villagePaint,       daySky, unit(Vec3{-0.55, 0.6, 0.55}),
            {2.5, 2.3, 1.95}, {0.42, 0.52, 0.68}, 70};
}
Stage planetStage() {
    return {nothing, noPaint, planetColour, {0, 1, 0}, {}, {}, 10};
}

}  // namespace generate
