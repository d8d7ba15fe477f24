// G9.S Stars on a map of the sky, at most one in each cell of a grid, and a milky band on the equator.
#version 410 core
#include "../modern/noise.glsl"

uniform float uDensity;     // part of the cells that have a star

in vec2 vST;
out vec4 fColor;

const float kTurn = 6.2831853;

void main() {
    float latitude = .5 * kTurn * (vST.t - .5);
    vec3 direction = vec3(cos(kTurn * vST.s) * cos(latitude), sin(latitude), sin(kTurn * vST.s) * cos(latitude));

    // Rows of equal height; each has as many cells as its length asks for.
    const float kRows = 64.;
    float row = floor(vST.t * kRows), middle = .5 * kTurn * ((row + .5) / kRows - .5);
    float columns = floor(2. * kRows * cos(middle)) + 1.;
    vec2 place = vec2(vST.s * columns, vST.t * kRows), cell = floor(place);
    vec3 random = randomOf(ivec3(cell, 0), 11u), more = randomOf(ivec3(cell, 1), 11u);
    // Brightness falls off within a few texels; most stars are faint.
    float r = distance(fract(place), .2 + .6 * random.xy) * kTurn / 2. / kRows;
    float magnitude = pow(more.x, 4.);
    float star = random.z < uDensity ? (.15 + .85 * magnitude) * exp(-pow(r / (.0018 + .002 * magnitude), 2.)) : 0.;
    vec3 tint = mix(vec3(1., .80, .62), vec3(.70, .82, 1.), more.y);

    float band = exp(-pow(latitude / .22, 2.)) * (.5 + .6 * fractalNoise(5. * direction, 4));
    vec3 color = max(band, 0.) * vec3(.16, .15, .20) + star * mix(tint, vec3(1.), magnitude);
    fColor = vec4(color, 1.);
}
