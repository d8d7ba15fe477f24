// EX16.13 Morph: each vertex moves in a straight line to the sphere of radius uRadius around the middle of the model.
#version 330 core

uniform float uBlend;
uniform float uRadius;

out vec3 vPosition;   // eye space

const vec3 kMiddle = vec3(-.3, 1.2, 0.);

void main() {
    vec3 fromMiddle = aVertex.xyz - kMiddle;
    float distance = max(length(fromMiddle), 1e-6);
    vec4 place = vec4(mix(fromMiddle, uRadius / distance * fromMiddle, uBlend), 1.);
    vPosition = vec3(uModelViewMatrix * place);
    gl_Position = uModelViewProjectionMatrix * place;
}
