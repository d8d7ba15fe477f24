// Gradient noise from an integer hash: 0 on the lattice, between -1 and 1, without a period that one could see.
uint scramble(uvec3 cell) {
    uint h = cell.x * 0x9E3779B1u ^ cell.y * 0x85EBCA77u ^ cell.z * 0xC2B2AE3Du;
    h ^= h >> 15;
    h *= 0x2C1B3C6Du;
    h ^= h >> 12;
    h *= 0x297A2D39u;
    return h ^ h >> 15;
}

float slope(ivec3 corner, vec3 from) {
    uint h = scramble(uvec3(corner));
    vec3 gradient = vec3(h & 1023u, h >> 10 & 1023u, h >> 20 & 1023u) / 511.5 - 1.;
    return dot(gradient, from);
}

float gradientNoise(vec3 place) {
    vec3 low = floor(place), f = place - low;
    ivec3 cell = ivec3(low);
    vec3 u = f * f * f * (f * (f * 6. - 15.) + 10.);
    vec4 lower, upper;
    for (int k = 0; k < 4; k++) {
        ivec3 corner = ivec3(k & 1, k >> 1, 0);
        lower[k] = slope(cell + corner, f - vec3(corner));
        corner.z = 1;
        upper[k] = slope(cell + corner, f - vec3(corner));
    }
    vec4 z = mix(lower, upper, u.z);
    vec2 y = mix(z.xy, z.zw, u.y);
    return mix(y.x, y.y, u.x);
}
