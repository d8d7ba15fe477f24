// R57 Tones and places: a matrix moves the picture, then a scale with a bias or a table of colours changes its brightness.
#version 330 core

uniform int uStep;                  // 0 places, 1 scale and bias, 2 luminance, 3 table
uniform mat3 uPlaces;               // from the square to the picture, for points (s - .5, t - .5, 1)
uniform vec3 uScale, uBias;
uniform sampler1DArray uTable;
uniform sampler2D uImageUnit;

in vec2 vST;

out vec4 fColor;

void main() {
    vec2 st = uStep == 0 ? (uPlaces * vec3(vST - .5, 1.)).st + .5 : vST;
    vec3 color = textureLod(uImageUnit, st, 0.).rgb;
    if (uStep == 0 && any(notEqual(st, clamp(st, 0., 1.)))) color = vec3(.12, .12, .15);
    if (uStep == 1) color = clamp(color * uScale + uBias, 0., 1.);
    float luminance = dot(color, vec3(.2125, .7154, .0721));
    if (uStep == 2) color = vec3(luminance);
    if (uStep == 3) color = texture(uTable, vec2((luminance * 255. + .5) / 256., 0.)).rgb;
    fColor = vec4(color, 1.);
}
