// R36 Lights the relief by its polynomial: a0 lu^2 + a1 lv^2 + a2 lu lv + a3 lu + a4 lv + a5. On the right the true light.
#version 330 core
#include "relief.glsl"

uniform sampler2D uHigh, uLow;
uniform vec2 uLight;
uniform vec3 uColor;
uniform bool uTrue;
uniform float uShine;

in vec2 vST;
out vec4 fColor;

void main() {
    vec3 high = texture(uHigh, vST).xyz, low = texture(uLow, vST).xyz;
    vec3 toLight = vec3(uLight, sqrt(max(1. - dot(uLight, uLight), 0.)));
    float light = uTrue ? reliefLight(vST, toLight)
                        : dot(high, vec3(uLight * uLight, uLight.x * uLight.y)) + dot(low, vec3(uLight, 1.));
    // The brightest light of a texel is where the polynomial's slope vanishes: that gives a normal, and so a highlight.
    vec2 best = vec2(high.z * low.y - 2. * high.y * low.x, high.z * low.x - 2. * high.x * low.y)
              / max(4. * high.x * high.y - high.z * high.z, 1e-3);
    best /= max(length(best) / .99, 1.);
    vec3 normal = vec3(best, sqrt(max(1. - dot(best, best), 0.)));
    float shine = uTrue ? 0. : uShine * pow(max(dot(normal, normalize(toLight + vec3(0., 0., 1.))), 0.), 60.);
    fColor = vec4(max(light, 0.) * uColor + shine, 1.);
}
