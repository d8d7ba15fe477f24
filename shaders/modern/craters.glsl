// The relief of the Moon as a function of a point of the unit sphere: plains, hills and craters of many sizes.
#include "noise.glsl"

/// The height of one crater at the distance r from its centre, in radii: a bowl, a rim, and a slope outward.
float craterProfile(float r) {
    float bowl = r * r - .8;
    float slope = .2 * exp(-6. * max(r - 1., 0.));
    return r < 1. ? max(min(bowl, slope), -.5) : slope - .2 * smoothstep(1., 1.8, r) * exp(-6. * (r - 1.));
}

/// One crater at most in each cell of a grid, which is finer for a higher frequency. Its size is random.
float craterField(vec3 p, float frequency, uint seed) {
    ivec3 first = ivec3(floor(p * frequency)) - 1;
    // A bit for each of the 27 cells around p whose crater may reach p. There are few, so what follows is short.
    uint some = 0u;
    for (int z = 0; z < 3; ++z) {
        uint layer = mixBits(uint(first.z + z) + mixBits(seed));
        for (int y = 0; y < 3; ++y) {
            uint row = mixBits(uint(first.y + y) + layer);
            for (int x = 0; x < 3; ++x) {
                vec3 center = vec3(first + ivec3(x, y, z)) + randomOfBits(uint(first.x + x) + row);
                float far = length(center), depth = abs(far - frequency);
                if (depth < .51 && distance(p * far, center) < 1. + depth) some |= 1u << (x + 3 * y + 9 * z);
            }
        }
    }
    float height = 0.;
    while (some != 0u) {
        int i = findLSB(some);
        some &= some - 1u;
        int row = i * 171 >> 9, layer = i * 57 >> 9;  // i / 3 and i / 9, up to 26
        ivec3 near = first + ivec3(i - 3 * row, row - 3 * layer, layer);
        vec3 center = (vec3(near) + randomOf(near, seed)) / frequency;
        float size = mix(.15, .5, randomOf(near, seed + 7u).x) / frequency;
        // A centre far above or below the surface makes no crater.
        float depth = abs(length(center) - 1.);
        if (depth > size) continue;
        height += size * (1. - depth / size) * craterProfile(distance(p, normalize(center)) / size);
    }
    return height;
}

/// Radii of the Moon, about -.1 to .1.
float moonHeight(vec3 p) {
    float height = .03 * fractalNoise(2. * p, 6);
    float frequency = 2.;
    for (uint level = 0u; level < 6u; ++level, frequency *= 2.) height += .35 * craterField(p, frequency, level);
    return height;
}
