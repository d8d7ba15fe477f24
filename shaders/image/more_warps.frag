// EX11.5 Warps: four ways to say which place of a picture is seen at a place of the square.
#version 330 core

uniform int uWarp;          // pinch, fisheye, kaleidoscope, tunnel
uniform float uAmount;      // 0 leaves the picture as it is
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

const float kPi = 3.14159265;

void main() {
    vec2 xy = 2. * vST - 1.;
    float r = length(xy);
    // The middle has no angle; any one will do.
    float angle = r > 0. ? atan(xy.y, xy.x) : 0.;
    vec2 to = xy;
    if (uWarp == 0 && r < 1.) {
        to = xy * pow(max(r, 1e-4), -.6 * uAmount * (1. - r));
    } else if (uWarp == 1 && r < 1.) {
        to = xy * mix(1., r, uAmount);
    } else if (uWarp == 2) {
        float sector = kPi / 3.;
        float folded = abs(mod(angle, sector) - sector / 2.);
        to = mix(xy, r * vec2(cos(folded), sin(folded)), uAmount);
    } else if (uWarp == 3) {
        vec2 tunnel = vec2(2. * abs(angle) / kPi - 1., 1. - 2. * clamp(r / 1.42, 0., 1.));
        to = mix(xy, tunnel, uAmount);
    }
    fColor = vec4(textureLod(uImageUnit, (to + 1.) / 2., 0.).rgb, 1.);
}
