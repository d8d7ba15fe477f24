// SH122 Fun with one: plots of t, t^2, t^3, 3t^2 - 2t^3, 10t^3 - 15t^4 + 6t^5, the triangle and three sines, with a dot at Timer.
#version 330 core

uniform float uS;   // speed of the last sine
uniform float uM;   // waves of the last but one

in vec2 vXY;

out vec4 fColor;

const float kTwoPi = 6.2831853;

float one(int which, float t) {
    if (which == 0) return t;
    if (which == 1) return t * t;
    if (which == 2) return t * t * t;
    if (which == 3) return t * t * (3. - 2. * t);
    if (which == 4) return t * t * t * (10. + t * (6. * t - 15.));
    if (which == 5) return 1. - abs(2. * t - 1.);
    if (which == 6) return .5 + .5 * sin(kTwoPi * t);
    if (which == 7) return .5 + .5 * sin(kTwoPi * uM * t);
    return abs(sin(.5 * kTwoPi * uS * t));
}

void main() {
    // Three columns and three rows; a panel is 0..1 with a margin for the bar.
    vec2 cell = vec2((vXY.x + 4.) / 8., (3. - vXY.y) / 6.) * 3.;
    int which = int(clamp(floor(cell.y), 0., 2.)) * 3 + int(clamp(floor(cell.x), 0., 2.));
    vec2 inCell = fract(cell);
    vec2 p = vec2((inCell.x - .08) / .72, (.88 - inCell.y) / .76);
    vec2 pixel = fwidth(cell) / vec2(.72, .76);

    vec3 paper = vec3(.97, .96, .93), ink = vec3(.10, .22, .45), red = vec3(.85, .22, .15);
    vec3 color = vec3(.88, .87, .84);
    bool inPlot = all(greaterThanEqual(p, vec2(0.))) && all(lessThanEqual(p, vec2(1.)));
    if (inPlot) {
        vec2 toGrid = abs(fract(4. * p + .5) - .5) / (4. * pixel);
        color = mix(vec3(.84, .86, .90), paper, clamp(min(toGrid.x, toGrid.y), 0., 1.));
    }
    if (p.x >= 0. && p.x <= 1.) {
        float slope = (one(which, p.x + .001) - one(which, p.x - .001)) / .002;
        float away = abs(p.y - one(which, p.x)) / (pixel.y * sqrt(1. + pow(slope * pixel.x / pixel.y, 2.)));
        color = mix(ink, color, smoothstep(.8, 1.8, away));
    }
    float value = one(which, Timer);
    float toDot = length((p - vec2(Timer, value)) / vec2(1., .76 / .72 * 4. / 3.) / .035);
    color = mix(red, color, smoothstep(.85, 1.15, toDot));
    if (p.x > 1.06 && p.x < 1.18 && p.y > 0. && p.y < 1.) color = p.y < value ? red : paper;
    fColor = vec4(color, 1.);
}
