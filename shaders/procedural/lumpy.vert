// R43 Vertex noise: each vertex of a sphere moves along its normal by noise that the vertex stage reads.
#version 330 core

uniform float uTime;
uniform float uHeight, uNoiseScale;

out vec3 vNormal;
out float vHeight;

float height(vec3 place) {
    vec4 octaves = textureLod(Noise3, uNoiseScale * place + vec3(0., .03, .05) * uTime, 0.) - .5;
    return uHeight * dot(octaves, vec4(2., 1., .5, .25));
}

void main() {
    vec3 n = aNormal;
    // Two directions along the sphere. Where the first vanishes another one is taken.
    vec3 along = normalize(abs(n.y) < .9 ? cross(vec3(0., 1., 0.), n) : cross(vec3(1., 0., 0.), n));
    vec3 across = cross(n, along);
    const float e = .03;
    vHeight = height(n);
    vec3 here = n * (1. + vHeight);
    vec3 right = normalize(n + e * along), up = normalize(n + e * across);
    right *= 1. + height(right);
    up *= 1. + height(up);
    vNormal = uNormalMatrix * normalize(cross(right - here, up - here));
    gl_Position = uModelViewProjectionMatrix * vec4(here, 1.);
}
