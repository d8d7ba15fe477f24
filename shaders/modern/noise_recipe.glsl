// G14.5 Noise recipe for textures in three dimensions: random values on a lattice, smoothed, and summed to turbulence. All
// of it repeats with the texture, if its size and the zooms are powers of two.

uniform int uSeed;

/// A random value in 0..1 for three integers and the seed (the hash pcg3d of Jarzynski and Olano 2020).
float randomValue(ivec3 at) {
    uvec3 v = uvec3(at) + 747796405u * uint(uSeed);
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    return float(v.x >> 8) / 16777216.;
}

/// Random values that are `zoom` texels apart, and between them their trilinear mixture.
float smoothNoise(vec3 texel, float zoom, ivec3 size) {
    vec3 p = texel / zoom, f = fract(p);
    ivec3 period = max(size / int(zoom), 1), low = ivec3(p) % period, high = (low + 1) % period;
    #define AT(x, y, z) randomValue(ivec3(x, y, z) + int(zoom) * 1024)
    vec4 alongX = mix(vec4(AT(low.x, low.y, low.z), AT(low.x, high.y, low.z), AT(low.x, low.y, high.z), AT(low.x, high.y, high.z)),
                      vec4(AT(high.x, low.y, low.z), AT(high.x, high.y, low.z), AT(high.x, low.y, high.z), AT(high.x, high.y, high.z)), f.x);
    #undef AT
    vec2 alongY = mix(alongX.xz, alongX.yw, f.y);
    return mix(alongY.x, alongY.y, f.z);
}

/// The sum of smooth noises of zoom, zoom/2, zoom/4 ... 1, each as strong as its zoom; in 0..256.
float turbulence(vec3 texel, float zoom, ivec3 size) {
    float sum = 0.;
    for (float z = zoom; z >= 1.; z /= 2.) sum += z * smoothNoise(texel, z, size);
    return 128. * sum / zoom;
}

/// From 0 to 1, most quickly where x is 0.
float logistic(float x, float k) {
    return 1. / (1. + exp(-k * x));
}
