// Gradient noise (Perlin 2002) with an integer hash, for shaders that make textures.

uint mixBits(uint x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

/// Three numbers in 0 to 1 that belong to `key`.
vec3 randomOfBits(uint key) {
    uint bits = mixBits(key);
    uvec3 three = uvec3(bits, mixBits(bits + 1u), mixBits(bits + 2u));
    return vec3(three >> 8) / 16777216.;
}

/// Three numbers in 0 to 1 that belong to a cell of the unit grid.
vec3 randomOf(ivec3 cell, uint seed) {
    return randomOfBits(uint(cell.x) + mixBits(uint(cell.y) + mixBits(uint(cell.z) + mixBits(seed))));
}

/// About -1 to 1. It repeats after `period` units along each axis, a power of two.
float gradientNoise(vec3 p, int period) {
    ivec3 cell = ivec3(floor(p));
    vec3 f = fract(p), weight = f * f * f * (f * (6. * f - 15.) + 10.);
    float corners[8];
    for (int i = 0; i < 8; ++i) {
        ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        vec3 gradient = 2. * randomOf((cell + corner) & (period - 1), 0u) - 1.;
        corners[i] = dot(gradient, f - vec3(corner));
    }
    vec4 left = vec4(corners[0], corners[2], corners[4], corners[6]);
    vec4 right = vec4(corners[1], corners[3], corners[5], corners[7]);
    vec4 x = mix(left, right, weight.x);
    vec2 y = mix(x.xz, x.yw, weight.y);
    return mix(y.x, y.y, weight.z);
}

/// The sum of octaves, each with twice the frequency and half the amplitude of the one before it.
float fractalNoise(vec3 p, int octaves) {
    float sum = 0., amplitude = 1.;
    for (int i = 0; i < octaves; ++i, amplitude *= .5, p *= 2.) sum += amplitude * gradientNoise(p, 1 << 20);
    return sum;
}
