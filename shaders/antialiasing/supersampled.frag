// R49 Supersampling: the pattern is computed at n x n places of each pixel, and the mean is shown.
#version 330 core

uniform int uSamples;       // per row of a pixel
uniform float uFrequency;

in vec2 vPlace;

out vec4 fColor;

// Rings and rays, sharp.
float pattern(vec2 place) {
    vec2 d = place - .5;
    float rings = step(.5, fract(uFrequency * length(d)));
    float rays = step(.5, fract(24. * atan(d.y, d.x == 0. && d.y == 0. ? 1. : d.x) / 6.2831853));
    return abs(rings - rays);
}

void main() {
    vec2 right = dFdx(vPlace), up = dFdy(vPlace);
    float sum = 0.;
    for (int j = 0; j < uSamples; j++)
        for (int i = 0; i < uSamples; i++) {
            vec2 offset = (vec2(i, j) + .5) / float(uSamples) - .5;
            sum += pattern(vPlace + offset.x * right + offset.y * up);
        }
    fColor = vec4(mix(vec3(.13, .11, .2), vec3(1., .93, .8), sum / float(uSamples * uSamples)), 1.);
}
