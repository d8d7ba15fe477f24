// Contours: green valleys to white peaks, with lines at equal steps of height, every fifth one thicker.
#version 330 core

#include "hills.glsl"

uniform float uStep;      // of height from line to line
uniform float uWidth;     // of the lines, pixels
uniform bool uColors, uLines;

in vec2 vXY;
in vec3 vPosition;

out vec4 fColor;

vec3 elevation(float h) {
    vec3 color = mix(vec3(.20, .42, .22), vec3(.62, .66, .34), smoothstep(0., .25, h));
    color = mix(color, vec3(.58, .44, .30), smoothstep(.25, .5, h));
    return mix(color, vec3(.97, .97, 1.), smoothstep(.55, .75, h));
}

void main() {
    float h = hills(vXY);
    vec3 normal = normalize(uNormalMatrix * vec3(-hillSlope(vXY), 1.));
    float light = .35 + .65 * max(dot(normal, normalize(vec3(-3., 4., 2.))), 0.);
    vec3 color = uColors ? elevation(h) : vec3(.85, .83, .78);

    if (uLines) {
        float steps = h / uStep;
        float number = round(steps);                               // of the nearest line; line 0 is the plain
        float pixels = abs(steps - number) / max(fwidth(steps), 1e-4);
        float wide = mod(number, 5.) == 0. ? 1.6 * uWidth : uWidth;
        float ink = number < .5 ? 0. : 1. - smoothstep(.5 * wide, .5 * wide + 1., pixels);
        color = mix(color, vec3(.16, .10, .08), .85 * ink);
    }
    fColor = vec4(light * color, 1.);
}
