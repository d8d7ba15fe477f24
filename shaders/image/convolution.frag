// D15 R61 Convolution: the weighted sum of 25 texels. The weights come from the scene.
#version 330 core

uniform float uKernel[25];      // row by row, from the lower left
uniform float uDivisor;
uniform float uBias;            // middle grey for kernels whose sum is 0
uniform float uUnsharp;         // 0 the sum, otherwise the picture plus its difference from the sum
uniform float uZoom;            // more than 1 shows a part of the picture, so that single texels are seen
uniform vec2 uCentre;           // of that part
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 step = 1. / vec2(textureSize(uImageUnit, 0));
    vec2 st = uCentre + (vST - .5) / uZoom;
    vec3 sum = vec3(0.);
    for (int k = 0; k < 25; k++)
        sum += uKernel[k] * texture(uImageUnit, st + step * vec2(k % 5 - 2, k / 5 - 2)).rgb;
    vec3 color = sum / uDivisor + uBias;
    if (uUnsharp > 0.) {
        vec3 here = texture(uImageUnit, st).rgb;
        color = here + uUnsharp * (here - color);
    }
    fColor = vec4(clamp(color, 0., 1.), 1.);
}
