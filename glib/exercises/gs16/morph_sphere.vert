// Exercise EX16.13: the model, about its middle.
#version 330 core

uniform float uBlend;
uniform float uRadius;

out vec3 vPosition;   // eye space

const vec3 kMiddle = vec3(-.3, 1.2, 0.);

void main() {
    vec3 fromMiddle = aVertex.xyz - kMiddle;
    vec3 onSphere = .1 * uRadius * fromMiddle;   // <- write this
    vec4 place = vec4(mix(fromMiddle, onSphere, uBlend), 1.);
    vPosition = vec3(uModelViewMatrix * place);
    gl_Position = uModelViewProjectionMatrix * place;
}
