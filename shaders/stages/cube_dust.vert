// Gx17.2 Cube dust: the number of the instance gives a cube its place in a large box, its turn and its colour; the number of
// the vertex gives its corners in a strip of 14.
#version 410 core

uniform mat4 vp_matrix;
uniform float uTime, uBox, uSize;  // half sides of the box and of a cube

flat out vec3 vColor;
out vec3 vPlace;

/// The hash pcg3d of Jarzynski and Olano 2020.
uvec3 hash(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    return v;
}

void main() {
    int bit = 1 << gl_VertexID;
    vec3 corner = 2. * vec3((0x287a & bit) != 0, (0x02af & bit) != 0, (0x31e3 & bit) != 0) - 1.;
    vec3 random = vec3(hash(uvec3(gl_InstanceID, 1u, 2u)) >> 8u) / 16777216.;
    vec3 other = vec3(hash(uvec3(gl_InstanceID, 3u, 4u)) >> 8u) / 16777216.;
    float angle = 6.2831853 * other.x + uTime * (.5 + other.y), c = cos(angle), s = sin(angle);
    vec3 turned = vec3(c * corner.x + s * corner.z, corner.y, c * corner.z - s * corner.x);
    turned = vec3(turned.x, c * turned.y - s * turned.z, s * turned.y + c * turned.z);
    vColor = .6 + .4 * other;
    vPlace = uBox * (2. * random - 1.) + uSize * turned;
    gl_Position = vp_matrix * vec4(vPlace, 1.);
}
