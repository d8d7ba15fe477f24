// V20 A map of random normals that lean a little: red and green are 0 to 31 bytes around the middle, blue is 255.
#version 330

uniform int uSeed;

in vec2 vST;
out vec4 fNormal;

/// The hash pcg3d of Jarzynski and Olano 2020.
uvec3 hash(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    return v;
}

void main() {
    uvec3 random = hash(uvec3(gl_FragCoord.xy, uSeed)) >> 27u;  // 0..31
    fNormal = vec4((vec2(random.xy) + 112.) / 255., 1., 1.);
}
