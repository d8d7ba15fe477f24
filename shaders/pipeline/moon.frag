// Gx6.1 A moon: grey plains and craters of three sizes, bowls with bright rims around random points of a grid on the map.
#version 410 core
#include "../modern/noise.glsl"

in vec2 vST;
out vec4 fColor;

float craters(vec2 place, ivec2 cells, uint seed) {
    float sum = 0.;
    ivec2 here = ivec2(floor(place * vec2(cells)));
    for (int i = 0; i < 9; ++i) {
        ivec2 cell = here + ivec2(i % 3, i / 3) - 1;
        vec3 random = randomOf(ivec3((cell.x + cells.x) % cells.x, cell.y, 0), seed);
        float radius = .15 + .3 * random.z;
        float r = distance(place * vec2(cells), vec2(cell) + random.xy) / radius;
        sum += (smoothstep(.75, 1., r) - smoothstep(1., 1.35, r)) * .25 - .15 * (1. - smoothstep(.6, .9, r));
    }
    return sum;
}

void main() {
    float plains = .5 + .16 * fractalNoise(vec3(4. * vST, 1.), 4);
    float relief = craters(vST, ivec2(8, 4), 1u) + .7 * craters(vST, ivec2(16, 8), 2u) +
                   .5 * craters(vST, ivec2(32, 16), 3u);
    fColor = vec4((plains + relief) * vec3(1., .98, .94), 1.);
}
