// S05 The height of each point goes up and down with time alone: a pulse, not a wave that travels.
#version 110

uniform float uTime;
uniform float xs, zs;

varying vec3 vPlace, vNormal;

void main() {
    vec4 place = gl_Vertex;
    place.y *= 1. + .2 * sin(xs * uTime) * sin(zs * uTime);
    vPlace = vec3(gl_ModelViewMatrix * place);
    vNormal = gl_NormalMatrix * gl_Normal;
    gl_Position = gl_ModelViewProjectionMatrix * place;
}
