// SH125 Morph: mixes position and normal on the sphere with those on the disk of radius 1 - t at the angle 2 pi s. The
// disk lies in the plane of the equator with the north pole in its middle.
#version 330 core

uniform float uBlend;

out vec2 vST;
out vec3 vPosition;   // eye space
out vec3 vNormal;     // eye space

void main() {
    vST = aTexCoord0.st;
    float angle = 6.2831853 * vST.s, radius = 1.2 * (1. - vST.t);
    vec3 onDisk = vec3(-radius * cos(angle), 0., radius * sin(angle));
    vec4 place = vec4(mix(aVertex.xyz, onDisk, uBlend), 1.);
    vec3 normal = mix(aNormal, vec3(0., 1., 0.), uBlend);
    if (dot(normal, normal) < 1e-6) normal = vec3(0., 1., 0.);   // opposite normals cancel
    vPosition = vec3(uModelViewMatrix * place);
    vNormal = uNormalMatrix * normal;
    gl_Position = uModelViewProjectionMatrix * place;
}
