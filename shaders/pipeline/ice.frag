// G5.1 Ice: pale blue plates with white cracks, the borders of the cells around random points.
#version 410 core
#include "../modern/noise.glsl"

in vec2 vST;
out vec4 fColor;

void main() {
    // Distances to the nearest two points, one per cell of a grid that repeats.
    const int kCells = 6;
    vec2 place = vST * float(kCells);
    float first = 9., second = 9., shade = 0.;
    for (int i = 0; i < 9; ++i) {
        ivec2 cell = ivec2(floor(place)) + ivec2(i % 3, i / 3) - 1;
        vec3 random = randomOf(ivec3((cell + kCells) % kCells, 0), 3u);
        float d = distance(place, vec2(cell) + random.xy);
        if (d < first) {
            second = first;
            first = d;
            shade = random.z;
        } else {
            second = min(second, d);
        }
    }
    float crack = 1. - smoothstep(.02, .09, second - first);
    float cloud = .5 + .5 * gradientNoise(vec3(16. * vST, 2.5), 16);
    vec3 plate = mix(vec3(.45, .68, .86), vec3(.72, .87, .95), .6 * shade + .4 * cloud);
    fColor = vec4(mix(plate, vec3(.97, .99, 1.), crack), 1.);
}
