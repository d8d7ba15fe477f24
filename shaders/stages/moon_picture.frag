// G12.3 A picture of craters: its grey is the height, 0 to 1.
#version 410 core
#include "modern/noise.glsl"

in vec2 vST;
out float fGrey;

/// A bowl with a rim, at the distance r from its middle in radii.
float crater(float r) {
    if (r > 1.6) return 0.;
    return r < 1. ? .9 * (r * r - .75) : .225 * (1.6 - r) / .6;
}

void main() {
    float height = .12 * fractalNoise(vec3(6. * vST, .5), 5);
    for (int level = 0; level < 5; ++level) {
        float cells = 4. * exp2(float(level));
        ivec2 cell = ivec2(floor(vST * cells));
        for (int i = 0; i < 9; ++i) {
            ivec2 near = cell + ivec2(i % 3, i / 3) - 1;
            vec3 random = randomOf(ivec3(near, level), 5u);
            float size = mix(.15, .45, random.z * random.z);
            height += size * 1.6 / cells * crater(distance(vST * cells, vec2(near) + random.xy) / size);
        }
    }
    fGrey = clamp(.5 + 1.6 * height, 0., 1.);
}
