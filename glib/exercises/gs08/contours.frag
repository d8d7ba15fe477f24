// Hills in one colour. Exercise: colour them by height, with contour lines.
#version 330 core

#include "shading/hills.glsl"

uniform float uStep;      // of height from line to line
uniform float uWidth;     // of the lines, pixels
uniform bool uColors, uLines;

in vec2 vXY;

out vec4 fColor;

vec3 elevation(float h) {
    return mix(vec3(.20, .42, .22), vec3(.62, .66, .34), h);   // 1
}

void main() {
    float h = hills(vXY);
    vec3 normal = normalize(uNormalMatrix * vec3(-hillSlope(vXY), 1.));
    float light = .35 + .65 * max(dot(normal, normalize(vec3(-3., 4., 2.))), 0.);
    vec3 color = uColors ? elevation(h) : vec3(.85, .83, .78);
    if (uLines) {
        float ink = h / uStep < 0. ? uWidth : 0.;              // 2, 3 (this only keeps the uniforms in use)
        color = mix(color, vec3(.16, .10, .08), .85 * ink);
    }
    fColor = vec4(light * color, 1.);
}
