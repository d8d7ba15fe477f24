// Apples, cherries and toys: still lifes seen at close range.
#include "distance.h"
#include "stages.h"

namespace generate {
namespace {

constexpr int kStem = 1;
constexpr int kCrate = 2;
constexpr int kFirstApple = 100;

// ---- Apples
// -------------------------------------------------------------------------------------------------

struct Apple {
    Vec3 centre;
    double size, tilt, turn;
    int kind;  // 0 red, 1 green, 2 golden
};

Apple appleAt(int i, int j, int layer) {
    const auto r = [&](std::uint32_t stream) { return random(i, j, layer, stream); };
    Apple a;
    a.centre = {1.95 * (i + 0.5 * (j & 1)) + 0.25 * r(1) + 0.97 * layer, -1.2 * layer + 0.35 * r(2),
                1.70 * j + 0.25 * r(3) + 0.55 * layer};
    a.size = 0.92 + 0.14 * r(4);
    a.tilt = 70 * r(5) - 15;
    a.turn = 360 * r(6);
    a.kind = r(7) < 0.5 ? 0 : (r(7) < 0.75 ? 1 : 2);
    return a;
}

Vec3 inApple(const Apple& a, Vec3 p) {
    return turnX(turnY(p - a.centre, a.turn), a.tilt) * (1 / a.size);
}

// A spindle torus, narrower at the bottom than at the shoulder. Its shape already has the dimples at both
// ends.
double appleBody(Vec3 q) {
    const double r = std::hypot(q.x, q.z) * (1 - 0.13 * q.y);
    return (std::hypot(r - 0.38, q.y / 1.28) - 0.60) * 0.85;
}

Surface applesSurface(Vec3 p) {
    Surface best{p.y + 2.6, kCrate};
    for (int layer = 0; layer < 2; ++layer) {
        const int j0 = static_cast<int>(std::lround((p.z - 0.55 * layer) / 1.70));
        for (int j = j0 - 1; j <= j0 + 1; ++j) {
            const int i0 = static_cast<int>(std::lround((p.x - 0.97 * layer) / 1.95 - 0.5 * (j & 1)));
            for (int i = i0 - 1; i <= i0 + 1; ++i) {
                const Apple a = appleAt(i, j, layer);
                const double around = length(p - a.centre) - 1.25;
                if (around > 0.4) {
                    best = nearer(best, {around, kCrate});
                    continue;
                }
                const Vec3 q = inApple(a, p);
                const int id = kFirstApple + layer * 10000 + (i + 50) * 100 + (j + 50);
                best = nearer(best, {appleBody(q) * a.size, id});
                best = nearer(best, {stick(q, {0, 0.4, 0}, {0.10, 0.92, 0.04}, 0.03, 0.05) * a.size, kStem});
            }
        }
    }
    return best;
}

Paint applesPaint(int paint, Vec3 p, Vec3) {
    if (paint == kStem) return {{0.10, 0.055, 0.02}, 0.05};
    if (paint == kCrate) return {{0.05, 0.035, 0.02}};
    const int id = paint - kFirstApple;
    const Apple a = appleAt(id / 100 % 100 - 50, id % 100 - 50, id / 10000);
    const Vec3 q = inApple(a, p);
    const double around = std::atan2(q.z, q.x);
    const double streak = turbulence({2 * std::cos(around) * 5, q.y * 1.5, 2 * std::sin(around) * 5}, 3, 11);
    const double blush =
        smooth(0.25, 0.75, 0.5 + 0.35 * std::sin(around + 6 * random(id, 1)) + 0.6 * (streak - 0.5));
    Vec3 skin;
    if (a.kind == 0) skin = mix(Vec3{0.55, 0.26, 0.03}, Vec3{0.48, 0.012, 0.016}, 0.35 + 0.65 * blush);
    if (a.kind == 1) skin = mix(Vec3{0.27, 0.44, 0.03}, Vec3{0.38, 0.42, 0.06}, blush);
    if (a.kind == 2) skin = mix(Vec3{0.72, 0.44, 0.05}, Vec3{0.62, 0.14, 0.03}, 0.6 * blush);
    const double freckle = smooth(0.80, 0.86, noise(q * 22, 17));
    skin = mix(skin, Vec3{0.75, 0.62, 0.30}, 0.45 * freckle);
    const double rim = smooth(0.28, 0.05, std::hypot(q.x, q.z) + (q.y < 0 ? 0.06 : 0));
    return {mix(skin, Vec3{0.22, 0.25, 0.05}, 0.7 * rim), 0.32, 90, 0.02};
}

Vec3 studioSky(Vec3 d) {
    const double window = smooth(0.80, 0.92, dot(d, unit(Vec3{-0.5, 0.8, 0.3})));
    return mix(Vec3{0.30, 0.31, 0.34}, Vec3{0.85, 0.88, 0.95}, 0.5 + 0.5 * d.y) +
           Vec3{1.2, 1.15, 1.05} * window;
}

// ---- Cherries
// -----------------------------------------------------------------------------------------------

enum CherryPaint { cloth, china, cherry, cherryStem, leaf };

Vec3 cherryAt(int i) {
    const double turn = 2.399963 * i, r = 0.30 * std::sqrt(i + 0.3);
    const double lift = 0.62 + (i % 3) * 0.10 + 0.5 * std::exp(-r * r * 0.9);
    return {r * std::cos(turn), lift, r * std::sin(turn)};
}

Surface cherriesSurface(Vec3 p) {
    Surface s{p.y, cloth};
    const double bowl = std::max(std::abs(length(p - Vec3{0, 1.55, 0}) - 1.75) - 0.05, p.y - 0.82);
    s = nearer(s, {blend(bowl, cylinder(p - Vec3{0, 0.03, 0}, 0.8, 0.05) - 0.02, 0.1), china});
    const auto fruit = [&](Vec3 centre, int i) {
        const Vec3 q = p - centre;
        if (length(q) > 1.6) {
            s = nearer(s, {length(q) - 1.5, cherry});
            return;
        }
        const double dimple = 0.09 * std::exp(-18 * (q.x * q.x + q.z * q.z)) * (q.y > 0 ? 1 : 0);
        s = nearer(s, {(length({q.x, q.y * 1.06, q.z}) - 0.27 + dimple) * 0.85, cherry + 10 * i});
        const double lean = 0.8 * (random(i, 5) - 0.5), side = 0.8 * (random(i, 6) - 0.5);
        const double t = std::clamp(q.y - 0.15, 0.0, 0.75);
        const Vec3 bend = {lean * t * t * 1.6, 0, side * t * t * 1.6};
        s = nearer(s, {stick(q - bend, {0, 0.12, 0}, {0, 0.9, 0}, 0.018, 0.03) * 0.6, cherryStem});
    };
    for (int i = 0; i < 19; ++i) fruit(cherryAt(i), i);
    fruit({2.0, 0.25, 0.9}, 30);
    fruit({1.55, 0.25, 1.35}, 31);
    fruit({-1.7, 0.25, 1.5}, 32);
    const Vec3 q = turnZ(turnY(p - Vec3{1.95, 0.42, 0.35}, 40), -12);
    const double blade = ellipsoid(q + Vec3{0, 0.35 * q.x * q.x, 0}, {0.62, 0.035, 0.28});
    return nearer(s, {blade * 0.6, leaf});
}

Paint cherriesPaint(int paint, Vec3 p, Vec3) {
    const int kind = paint % 10;
    if (kind == cherry) {
        const double dark = random(paint, 3);
        return {mix(Vec3{0.42, 0.008, 0.02}, Vec3{0.16, 0.004, 0.018}, dark), 1.3, 130, 0.05};
    }
    if (kind == china) return {{0.72, 0.74, 0.76}, 0.7, 90, 0.06};
    if (kind == cherryStem) return {{0.14, 0.17, 0.03}, 0.1};
    if (kind == leaf) {
        const Vec3 q = turnZ(turnY(p - Vec3{1.95, 0.42, 0.35}, 40), -12);
        const double vein = smooth(0.08, 0.0, std::abs(fract(5 * (std::abs(q.z) + 0.8 * q.x)) - 0.5) * 0.5);
        return {mix(Vec3{0.06, 0.20, 0.03}, Vec3{0.20, 0.36, 0.08}, vein), 0.25, 30};
    }
    const bool a = fract(p.x * 0.7) < 0.5, b = fract(p.z * 0.7) < 0.5;
    const double weave = 0.9 + 0.1 * std::sin(p.x * 90) * std::sin(p.z * 90);
    const Vec3 white = {0.74, 0.72, 0.68}, blue = {0.05, 0.12, 0.36};
    return {mix(white, blue, 0.5 * a + 0.5 * b) * weave};
}

// ---- Toys
// ---------------------------------------------------------------------------------------------------

enum ToyPaint { table, redBall, mirrorBall, blueBox, yellowCone, greenRing, violetBall, whitePillar };

Surface toysSurface(Vec3 p) {
    Surface s{p.y, table};
    s = nearer(s, {sphere(p - Vec3{-1.55, 0.7, 0.4}, 0.7), redBall});
    s = nearer(s, {sphere(p - Vec3{0.15, 1.0, -0.9}, 1.0), mirrorBall});
    s = nearer(s, {box(turnY(p - Vec3{1.85, 0.6, 0.1}, 28), {0.6, 0.6, 0.6}, 0.08), blueBox});
    s = nearer(s, {cone(p - Vec3{-2.0, 0, -1.7}, 0.75, 2.1) * 0.9, yellowCone});
    s = nearer(s, {ring(p - Vec3{0.35, 0.22, 1.35}, 0.55, 0.22), greenRing});
    s = nearer(s, {sphere(p - Vec3{-0.75, 0.35, 1.75}, 0.35), violetBall});
    s = nearer(s, {sphere(p - Vec3{0.35, 0.55, 1.35}, 0.28), violetBall});
    return nearer(s, {cylinder(p - Vec3{2.1, 1.1, -1.9}, 0.5, 1.1) - 0.03, whitePillar});
}

Paint toysPaint(int paint, Vec3 p, Vec3) {
    switch (paint) {
        case redBall:
            return {{0.60, 0.03, 0.03}, 0.6, 60, 0.04};
        case mirrorBall:
            return {{0.20, 0.20, 0.20}, 1.0, 300, 0.85};
        case blueBox: {
            const bool stripe = fract(p.y * 2.5) < 0.22;
            return {stripe ? Vec3{0.7, 0.7, 0.7} : Vec3{0.02, 0.10, 0.55}, 0.3, 30};
        }
        case yellowCone:
            return {{0.75, 0.50, 0.02}, 0.2, 20};
        case greenRing:
            return {{0.05, 0.42, 0.09}, 0.7, 80, 0.04};
        case violetBall:
            return {{0.30, 0.05, 0.45}, 0.7, 90, 0.05};
        case whitePillar: {
            const double a = std::atan2(p.z + 1.9, p.x - 2.1) / 6.2831853;
            const bool check = (fract(a * 6) < 0.5) != (fract(p.y * 1.4) < 0.5);
            return {check ? Vec3{0.72, 0.68, 0.60} : Vec3{0.55, 0.14, 0.05}, 0.2, 30};
        }
        default:
            break;
    }
    const double ringShade =
        fract(9 * std::hypot(p.x * 0.25 + 3, p.z) + 2.5 * turbulence({p.x * 0.8, 0, p.z * 3}, 3, 5));
    const double grain = 0.8 + 0.3 * noise({p.x * 6, 0, p.z * 60}, 9);
    return {mix(Vec3{0.42, 0.22, 0.09}, Vec3{0.28, 0.13, 0.05}, ringShade) * grain, 0.15, 25, 0.03};
}

}  // namespace

Stage applesStage() {
    return {applesSurface,    applesPaint,       studioSky, unit(Vec3{-0.5, 0.85, 0.35}),
            {2.6, 2.45, 2.2}, {0.55, 0.57, 0.62}};
}
Stage cherriesStage() {
    return {cherriesSurface,  cherriesPaint,     studioSky, unit(Vec3{-0.6, 0.75, 0.45}),
            {2.5, 2.35, 2.1}, {0.55, 0.58, 0.65}};
}
Stage toysStage() {
    return {toysSurface,     toysPaint,         studioSky, unit(Vec3{-0.55, 0.7, 0.6}),
            {2.3, 2.2, 2.0}, {0.50, 0.54, 0.62}};
}

}  // namespace generate
