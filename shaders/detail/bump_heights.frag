// G10.f9 Heights of rows of rivets and a fine grain; the map repeats.
#version 410 core
#include "../modern/noise.glsl"

in vec2 vST;
out float fHeight;

void main() {
    vec2 place = vST * vec2(16., 8.);
    if (mod(floor(place.y), 2.) == 1.) place.x += .5;
    vec2 p = fract(place) - .5;
    float rivet = sqrt(max(.09 - dot(p, p), 0.));
    fHeight = .055 * rivet + .0012 * gradientNoise(vec3(64. * vST, .5), 64);
}
