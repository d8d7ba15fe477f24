// Heights of waves: one layer of a cube that repeats in all directions. Its slices along y are moments of the water.
#version 410 core
#include "modern/noise.glsl"

uniform int uLayer, uLayers;

in vec2 vST;
out float fHeight;

void main() {
    vec3 p = vec3(vST, (float(uLayer) + .5) / float(uLayers));
    float height = .25 * sin(6.2831853 * (p.x + p.z - p.y)), amplitude = .6;
    for (int octave = 4; octave <= 16; octave *= 2, amplitude *= .5)
        height += amplitude * gradientNoise(float(octave) * p, octave);
    fHeight = height;
}
